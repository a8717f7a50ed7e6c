#include "sim/campaign/wiring/sketch_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robosim::wiring {
namespace sketch_names_test {

using testing::ElementsAre;
using testing::IsEmpty;

Pin pin(const char* name) { return find_pin(*find_board("uno"), name); }

SketchNames names(const std::string& text) { return names_in_text(text, "a.ino", *find_board("uno")); }

TEST(SketchNames, AConstantIsANameWhereAFunctionOfPinsTakesIt) {
  const SketchNames found = names(
      "#define ENA 5  // left\n"
      "const int IN1 = 7, IN2 = (8);\n"
      "int speed = 9;\n"
      "enum { LED = 13 };\n"
      "#define ALIAS ENA\n"
      "void setup() { pinMode(ALIAS, OUTPUT); pinMode(IN1, OUTPUT); digitalWrite(LED, HIGH); delay(speed); "
      "}\n");
  std::vector<std::string> list;
  for (const Named& named : found.named)
    if (named.sure) list.push_back(named.name);
  EXPECT_THAT(list, ElementsAre("IN1", "LED", "ALIAS")) << "a speed is not a pin, and ENA is found as ALIAS";
  EXPECT_THAT(found.named.back().pins, ElementsAre(pin("D5")));
  EXPECT_EQ(found.named[0].spot.line, 2);
}

TEST(SketchNames, WhatComesOfAReadNamesThePin) {
  const SketchNames found = names("void loop() {\n  int left = analogRead(A1);\n}\n");
  ASSERT_EQ(found.named.size(), 1u);
  EXPECT_EQ(found.named[0].name, "left");
  EXPECT_THAT(found.named[0].pins, ElementsAre(pin("A1")));
}

TEST(SketchNames, AnArrayOfAnalogPinsIsOneWhoeverTakesIt) {
  const SketchNames found = names("const uint8_t SENSORS[] = {A3, A2, A1};\nint table[3] = {1, 2, 3};\n");
  ASSERT_EQ(found.named.size(), 1u);
  EXPECT_TRUE(found.named[0].is_array);
  EXPECT_THAT(found.named[0].pins, ElementsAre(pin("A3"), pin("A2"), pin("A1")));
}

TEST(SketchNames, ANumberForAnalogReadIsAChannel) {
  const SketchNames found =
      names("int eye = 0, led = 3;\nvoid loop() { analogRead(eye); digitalWrite(led, 1); }\n");
  ASSERT_EQ(found.named.size(), 2u);
  EXPECT_THAT(found.named[0].pins, ElementsAre(pin("A0")));
  EXPECT_THAT(found.named[1].pins, ElementsAre(pin("D3")));
}

TEST(SketchNames, AVariableThatChangesIsNoPinUnlessAFunctionOfPinsTakesIt) {
  const SketchNames found = names(
      "int currentState = 1, motor = 5;\n"
      "void act(int state) {}\n"
      "void loop() { act(currentState); currentState = 2; analogWrite(motor, 9); motor = 6; act(motor); }\n");
  ASSERT_EQ(found.named.size(), 1u);
  EXPECT_EQ(found.named[0].name, "motor");
}

TEST(SketchNames, ACountIsNoPin) {
  const SketchNames found = names(
      "#define NUM_SENSORS 6\n#define sensorSayisi 8\n#define EMITTER 3\n"
      "QTRSensorsRC qtr((unsigned char[]){2, 4}, NUM_SENSORS, sensorSayisi, EMITTER);\n");
  ASSERT_EQ(found.named.size(), 1u);
  EXPECT_EQ(found.named[0].name, "EMITTER");
}

TEST(SketchNames, CommentsAndStringsSayNothing) {
  EXPECT_THAT(
      names("// #define A 5\n/* int b = 6; pinMode(b, OUTPUT); */ char* s = \"pinMode(7, OUTPUT)\";\n").named,
      IsEmpty());
}

TEST(SketchNames, LibrariesAreToldWithTheirPinsInOrder) {
  const SketchNames found = names(
      "#define TRIG 12\n#define ECHO 11\n"
      "NewPing sonar(TRIG, ECHO, 200);\n"
      "Motors motors(Motor(5, 7, 8), Motor(6, 9, 10));\n"
      "void setup() { pan.attach(9); qtr.setSensorPins((const uint8_t[]){A0, A1}, 2); }\n");
  ASSERT_EQ(found.given.size(), 5u);
  EXPECT_EQ(found.given[0].type, "NewPing");
  EXPECT_EQ(found.given[0].name, "sonar");
  EXPECT_THAT(found.given[0].pins, ElementsAre(12, 11, kNoPin)) << "200 is not a pin";
  EXPECT_THAT(found.given[1].pins, ElementsAre(5, 7, 8));
  EXPECT_THAT(found.given[2].pins, ElementsAre(6, 9, 10));
  EXPECT_EQ(found.given[3].name, "pan");
  EXPECT_THAT(found.given[3].pins, ElementsAre(9));
  EXPECT_THAT(found.given[4].pins, ElementsAre(pin("A0"), pin("A1"), 2));
}

TEST(SketchNames, AnUnfinishedSourceIsReadAsFarAsItGoes) {
  for (const char* text : {"", "#define", "#define X", "int a[", "int a[] = {", "pinMode(", "enum {", "enum",
                           "\"", "/*", "Servo s(", "new", "new X(", "x.attach(", "'\\", "int a = 1,",
                           "#define A A\npinMode(A, 1);", "#define A B\n#define B A\npinMode(A, 1);"})
    names(text);
}

TEST(Words, ANameIsTakenApart) {
  EXPECT_THAT(words_of("leftMotor_EN1"), ElementsAre("left", "motor", "en", "1"));
  EXPECT_THAT(words_of("IN1"), ElementsAre("in", "1"));
  EXPECT_THAT(words_of("PWMPin"), ElementsAre("pwm", "pin"));
  EXPECT_THAT(words_of("_x"), ElementsAre("x"));
}

}  // namespace sketch_names_test
}  // namespace robosim::wiring
