#include "sim/build/pin_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace pin_warnings_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string on(const char* board, const std::string& code) {
  return pin_warnings("#line 1 \"My.ino\"\nvoid setup() {\n" + code + "\n}\n", *find_board(board));
}

TEST(PinWarnings, NameAPinThatTheBoardLacksWithItsLineAndTheBoardsThatHaveIt) {
  EXPECT_EQ(on("uno", "pinMode(50, OUTPUT);"),
            "My.ino:2: warning: pinMode(50, …): the uno has no pin 50; these boards have one: mega");
  EXPECT_EQ(on("mega", "pinMode(50, OUTPUT);"), "");
  EXPECT_THAT(on("uno", "int x = digitalRead(99);"), HasSubstr("no board in Robosim has one"));
  EXPECT_THAT(on("uno", "analogRead(9);"), HasSubstr("the uno has no pin A9"));
  EXPECT_EQ(on("uno", "analogRead(5); analogRead(A5); analogRead(19);"), "");
}

TEST(PinWarnings, FollowAVariableThatIsSetOnce) {
  EXPECT_THAT(on("uno", "const byte led = 0x32; digitalWrite(led, HIGH);"),
              StartsWith("My.ino:2: warning: digitalWrite(led, …): the uno has no pin 50"));
  EXPECT_EQ(on("uno", "int i = 50; i = 3; digitalWrite(i, HIGH);"), "");
  EXPECT_EQ(on("uno", "int i = 50; i++; digitalWrite(i, HIGH);"), "");
  EXPECT_EQ(on("uno", "int i = 50; find(&i); digitalWrite(i, HIGH);"), "");
  EXPECT_EQ(on("uno", "int p = 50; } void set(int p) { digitalWrite(p, HIGH);"), "");
  EXPECT_EQ(on("uno", "int p = 50; for (byte p : pins) digitalWrite(p, HIGH);"), "");
  EXPECT_EQ(on("uno", "digitalWrite(-1, HIGH); digitalWrite(300, HIGH); digitalWrite(pins[50], 1);"), "");
  EXPECT_EQ(on("uno", "expander.digitalWrite(50, HIGH); print(\"pinMode(50, 1)\");"), "");
}

TEST(PinWarnings, SayThatAPinHasNoPwmUnlessItIsAllOrNothing) {
  EXPECT_EQ(on("uno", "analogWrite(4, speed);"),
            "My.ino:2: warning: analogWrite(4, …): pin D4 of the uno has no PWM: it is LOW below 128 and "
            "HIGH otherwise; "
            "these pins have PWM: D3, D5, D6, D9, D10, D11");
  EXPECT_EQ(on("uno", "analogWrite(4, 255); analogWrite(4, 0); analogWrite(5, 100);"), "");
}

TEST(PinWarnings, SayWhatAValueBeyondPwmComesTo) {
  EXPECT_EQ(
      on("uno", "analogWrite(5, 300);"),
      "My.ino:2: warning: analogWrite(5, 300): expected 0 to 255; on most pins 300 has the effect of 44");
  EXPECT_THAT(on("uno", "analogWrite(en, -100);"), HasSubstr("-100 has the effect of 156"));
  EXPECT_EQ(on("uno", "analogWrite(5, 255); analogWrite(5, speed - 300); analogWrite(5, 2 * 300);"), "");
  EXPECT_EQ(on("uno", "analogWriteResolution(10); analogWrite(5, 1000);"), "");
}

TEST(PinWarnings, SayThatSerialIsNeverBegun) {
  const auto of = [](const char* board, const std::string& code, const std::string& header = "") {
    const std::string own = "#line 1 \"My.ino\"\n" + code;
    return serial_warning(own, header + own, *find_board(board));
  };
  const std::string prints = "void loop() {\n  Serial.println(1);\n}\n";
  EXPECT_THAT(of("uno", prints), StartsWith("My.ino:2: warning: Serial is never begun"));
  EXPECT_EQ(of("uno", prints + "void setup() { Serial.begin(9600); }"), "");
  EXPECT_EQ(of("uno", prints, "void start() { Serial.begin(9600); }\n"), "");
  EXPECT_EQ(of("uno", prints + "void setup() { start(Serial); }"), "");
  EXPECT_EQ(of("leonardo", prints), "") << "its Serial is a USB";
  EXPECT_EQ(of("uno", "void loop() { if (Serial.read() == 1) stop(); }"), "");
}

TEST(PinWarnings, SayThatAPinIsAnalogOnly) {
  EXPECT_THAT(on("nano", "pinMode(A6, INPUT_PULLUP);"),
              HasSubstr("pin A6 of the nano can only be read with analogRead()"));
  EXPECT_EQ(on("nano", "analogRead(A6); analogRead(7);"), "");
}

class PinWarningsOf : public SketchTest {};

TEST_F(PinWarningsOf, ASketchAreAmongTheCompilersWithMacrosReplaced) {
  write("My/My.ino", "#define LAMP 40\nvoid setup() {\n  pinMode(LAMP, OUTPUT);\n}\nvoid loop() {}\n");
  EXPECT_THAT(build_here("My").messages,
              HasSubstr("My.ino:3: warning: pinMode(40, …): the uno has no pin 40"));
}

}  // namespace pin_warnings_test
}  // namespace robosim::build
