#include "sim/build/hints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robosim::build {
namespace hints_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

TEST(Hints, APinOfOtherBoardsIsToldWithTheBoards) {
  EXPECT_THAT(hint_for("a.ino:1:2: error: 'A8' was not declared in this scope; did you mean 'A7'?"),
              AllOf(HasSubstr("mega"), HasSubstr("leonardo"), HasSubstr("--robot NAME@BOARD")));
  EXPECT_THAT(hint_for("a.ino:1:2: error: 'A99' was not declared in this scope"),
              HasSubstr("no board has a pin A99"));
}

TEST(Hints, OfSeveralPinsTheBoardsHaveAll) {
  EXPECT_THAT(
      hint_for("a.ino:1:2: error: 'A8' was not declared in this scope\n"
               "a.ino:2:2: error: 'A12' was not declared in this scope"),
      HasSubstr("these boards have the pins A8, A12: mega; run the sketch on one of them with --robot"));
}

TEST(Hints, ASerialLineOfOtherBoardsIsToldWithTheBoards) {
  EXPECT_THAT(hint_for("a.ino:1:2: error: 'Serial1' was not declared in this scope"),
              HasSubstr("these boards have Serial1: mega, leonardo, micro; run the sketch"));
  EXPECT_THAT(hint_for("a.ino:1:2: error: 'Serial3' was not declared in this scope"),
              HasSubstr("these boards have Serial3: mega; run the sketch"));
}

TEST(Hints, APinsNameOnAnEsp8266IsANumberHere) {
  EXPECT_THAT(hint_for("a.ino:1:2: error: 'D5' was not declared in this scope"), HasSubstr("it is 5"));
}

TEST(Hints, ALibrarysClassNamesItsHeader) {
  EXPECT_THAT(hint_for("a.ino:4:1: error: 'Servo' does not name a type"), HasSubstr("#include <Servo.h>"));
}

TEST(Hints, ASketchForAnotherVersionOfALibraryIsToldWhich) {
  EXPECT_THAT(
      hint_for("a.ino:36:1: error: 'QTRSensorsAnalog' does not name a type; did you mean 'QTRSensors'?"),
      EndsWith(
          "another version of the library QTRSensors; install it: arduino-cli lib install QTRSensors@3.1.0"));
  EXPECT_THAT(hint_for("a.ino:29:12: error: 'QTRSensors::QTRSensors()' is protected within this context\n"
                       "QTRSensors.h:121:5: note: declared protected here"),
              EndsWith("lib install QTRSensors@4.0.0"));
  EXPECT_THAT(hint_for("a.ino:4:1: error: 'QTRSensors' does not name a type"),
              HasSubstr("#include <QTRSensors.h>"));
  EXPECT_EQ(hint_for("a.ino:4:1: error: 'QTRSensorsRC' does not name a type"), "")
      << "the sketch includes no version of the library";
}

TEST(Hints, OtherBoardsProgramsAreToldWhatIsSimulated) {
  for (const char* message : {"error: 'ledcSetup' was not declared in this scope",
                              "error: 'input' does not name a type", "error: 'from' does not name a type"})
    EXPECT_THAT(hint_for(message), HasSubstr("Robosim simulates the Blue Pill")) << message;
  EXPECT_THAT(foreign_header("WiFi.h"), HasSubstr("WiFi.h is for an ESP32; Robosim"));
  EXPECT_THAT(foreign_header("esp_task_wdt.h"), HasSubstr("an ESP32"));
  EXPECT_THAT(foreign_header("WiFiS3.h"), HasSubstr("an Arduino Uno R4"));
  EXPECT_THAT(foreign_header("hardware/pwm.h"), HasSubstr("an RP2040"));
  EXPECT_EQ(foreign_header("hardware/motors.h"), "") << "a folder of the sketch may have this name";
  EXPECT_EQ(foreign_header("Servo.h"), "");
  EXPECT_EQ(library_of_header("PID_v1.h"), "PID");
  EXPECT_EQ(library_of_header("Mine.h"), "");
}

TEST(Hints, ANameThatTheChipsHeadersDefineIsNamed) {
  EXPECT_THAT(hint_for("a.ino:1:11: error: expected unqualified-id before numeric constant\n"
                       " const int SPEED = 110;\n"
                       "           ^\n"),
              HasSubstr("SPEED is already a number in this chip's headers"));
  EXPECT_THAT(hint_for("a.ino:2:14: error: expected identifier before numeric constant\n"
                       "    2 | enum { USBS, OTHER };\n"
                       "      |        ^~~~\n"),
              HasSubstr("USBS is already a number"));
  EXPECT_EQ(hint_for("a.ino:1:5: error: expected unqualified-id before numeric constant\n"
                     " int 5;\n"
                     "     ^\n"),
            "");
}

TEST(Hints, OnlyTheFirstErrorIsLookedAt) {
  EXPECT_EQ(hint_for("a.ino:1:2: error: 'speed' was not declared in this scope\n"
                     "a.ino:2:2: error: 'A8' was not declared in this scope"),
            "");
  EXPECT_EQ(hint_for(""), "");
}

TEST(Hints, WhatTheChipsCompilerIsTooOldForIsNamed) {
  EXPECT_THAT(hint_for("a.ino:1:14: error: expected '{' before '::' token"), HasSubstr("C++17"));
  EXPECT_THAT(hint_for("a.ino:2:7: error: expected '(' before 'constexpr'"), HasSubstr("C++17"));
}

TEST(Hints, WhatIsForgottenIsNamed) {
  EXPECT_THAT(hint_for("error: 'include' does not name a type"), HasSubstr("#include"));
  EXPECT_THAT(hint_for("error: expected ',' or ';' before 'return'"), HasSubstr("a ;"));
  EXPECT_THAT(hint_for("error: expected '}' at end of input"), HasSubstr("}"));
  EXPECT_THAT(hint_for("error: redefinition of 'void setup()'"), HasSubstr("one setup()"));
}

}  // namespace hints_test
}  // namespace robosim::build
