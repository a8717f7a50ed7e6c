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
            "My.ino:2: warning: analogWrite(4, …): pin D4 of the uno has no PWM: it is LOW for values below "
            "128, and HIGH otherwise; these pins have PWM: D3, D5, D6, D9, D10, D11");
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
  EXPECT_THAT(of("uno", prints), StartsWith("My.ino:2: warning: Serial.begin() is never called"));
  EXPECT_EQ(of("uno", prints + "void setup() { Serial.begin(9600); }"), "");
  EXPECT_EQ(of("uno", prints, "void start() { Serial.begin(9600); }\n"), "");
  EXPECT_EQ(of("uno", prints + "void setup() { start(Serial); }"), "");
  EXPECT_EQ(of("leonardo", prints), "") << "a Leonardo's Serial is a USB port";
  EXPECT_EQ(of("uno", "void loop() { if (Serial.read() == 1) stop(); }"), "");
}

TEST(PinWarnings, SayThatASketchWaitsForAComputerThatARobotOnTheFloorDoesNotHave) {
  const auto of = [](const char* board, const std::string& code) {
    return usb_warning("#line 1 \"My.ino\"\nvoid setup() {\n  " + code + "\n}\n", *find_board(board));
  };
  EXPECT_THAT(of("leonardo", "while (!Serial) {}"),
              AllOf(StartsWith("My.ino:2: warning: 'while (!Serial)' waits until a computer opens the port"),
                    HasSubstr("while (!Serial && millis() < 2000)")));
  EXPECT_THAT(of("micro", "while (!Serial);"), StartsWith("My.ino:2: "));
  EXPECT_THAT(of("leonardo", "while(!Serial) { delay(10); }"), StartsWith("My.ino:2: "));
  EXPECT_EQ(of("leonardo", "while (!Serial && millis() < 3000);"), "");
  EXPECT_EQ(of("leonardo", "if (!Serial) return;"), "");
  EXPECT_EQ(of("leonardo", "while (!Serial.available());"), "");
  EXPECT_EQ(of("uno", "while (!Serial) {}"), "") << "an Uno's port is open at once";
}

TEST(PinWarnings, SayThatAPinIsAnalogOnly) {
  EXPECT_THAT(on("nano", "pinMode(A6, INPUT_PULLUP);"),
              HasSubstr("pin A6 of the nano can only be read with analogRead()"));
  EXPECT_EQ(on("nano", "analogRead(A6); analogRead(7);"), "");
}

/// These functions return the expression to which the Arduino core's macro digitalPinToInterrupt(pin)
/// expands, for an Uno and for a Mega.
std::string uno_interrupt(const std::string& pin) {
  return "((" + pin + ") == 2 ? 0 : ((" + pin + ") == 3 ? 1 : -1))";
}
std::string mega_interrupt(const std::string& pin) {
  return "((" + pin + ") == 2 ? 0 : ((" + pin + ") == 3 ? 1 : ((" + pin + ") >= 18 && (" + pin +
         ") <= 21 ? 23 - (" + pin + ") : -1)))";
}

TEST(PinWarnings, SayThatAPinHasNoExternalInterruptAndWhichPinsHaveOne) {
  EXPECT_EQ(on("uno", "attachInterrupt(" + uno_interrupt("4") + ", tick, CHANGE);"),
            "My.ino:2: warning: attachInterrupt(digitalPinToInterrupt(4), …): pin D4 of the uno has no "
            "external interrupt: its handler never runs; these pins have one: D2, D3");
  EXPECT_THAT(on("uno", "const byte left = 7; attachInterrupt(" + uno_interrupt("left") + ", tick, 1);"),
              HasSubstr("attachInterrupt(digitalPinToInterrupt(left), …): pin D7 of the uno has no"));
  EXPECT_THAT(on("nano", "attachInterrupt(" + uno_interrupt("A0") + ", tick, CHANGE);"),
              HasSubstr("pin A0 of the nano has no external interrupt"));
  EXPECT_THAT(on("mega", "attachInterrupt(" + mega_interrupt("10") + ", tick, CHANGE);"),
              HasSubstr("these pins have one: D2, D3, D18, D19, D20, D21"));
  EXPECT_THAT(on("uno", "attachInterrupt(" + uno_interrupt("50") + ", tick, CHANGE);"),
              HasSubstr("the uno has no pin 50"));
}

TEST(PinWarnings, AcceptPinsThatHaveAnExternalInterruptOrAreNotKnown) {
  EXPECT_EQ(on("uno", "attachInterrupt(" + uno_interrupt("3") + ", tick, CHANGE);"), "");
  EXPECT_EQ(on("mega", "attachInterrupt(" + mega_interrupt("20") + ", tick, CHANGE);"), "");
  EXPECT_EQ(on("bluepill", "attachInterrupt(((4) < 32 ? (4) : -1), tick, CHANGE);"), "");
  EXPECT_EQ(on("uno", "byte p = 4; p = choose(); attachInterrupt(" + uno_interrupt("p") + ", tick, 1);"), "");
  EXPECT_EQ(on("uno", "attachInterrupt(" + uno_interrupt("pins[4]") + ", tick, CHANGE);"), "");
  EXPECT_EQ(on("uno", "expander.attachInterrupt(" + uno_interrupt("4") + ", tick, CHANGE);"), "");
}

TEST(PinWarnings, SayThatAnInterruptsNumberIsThatOfAPin) {
  EXPECT_EQ(on("uno", "attachInterrupt(2, tick, RISING);"),
            "My.ino:2: warning: attachInterrupt(2, …): the uno has no interrupt 2: the handler never runs; "
            "for pin D2, write attachInterrupt(digitalPinToInterrupt(2), …)");
  EXPECT_THAT(on("uno", "const int encoder = 3; attachInterrupt(encoder, tick, RISING);"),
              HasSubstr("for pin D3, write attachInterrupt(digitalPinToInterrupt(encoder), …)"));
  EXPECT_THAT(on("uno", "attachInterrupt(5, tick, RISING);"),
              HasSubstr("the uno has no interrupt 5: the handler never runs; these interrupts exist: "
                        "0 (pin D2), 1 (pin D3)"));
  EXPECT_THAT(on("mega", "attachInterrupt(19, tick, RISING);"), HasSubstr("for pin D19, write"));
}

TEST(PinWarnings, AcceptTheNumbersOfTheBoardsInterrupts) {
  EXPECT_EQ(on("uno", "attachInterrupt(0, left, RISING); attachInterrupt(1, right, RISING);"), "");
  EXPECT_EQ(on("mega", "attachInterrupt(2, left, RISING); attachInterrupt(5, right, RISING);"), "");
  EXPECT_EQ(on("leonardo", "attachInterrupt(4, left, RISING);"), "");
  EXPECT_EQ(on("bluepill", "attachInterrupt(22, left, RISING);"), "")
      << "this board's interrupts have the pins' numbers";
  EXPECT_EQ(on("uno", "int n = 2; n = number_of(pin); attachInterrupt(n, left, RISING);"), "");
}

class PinWarningsOf : public SketchTest {};

TEST_F(PinWarningsOf, ASketchAreAmongTheCompilersWithMacrosReplaced) {
  write("My/My.ino", "#define LAMP 40\nvoid setup() {\n  pinMode(LAMP, OUTPUT);\n}\nvoid loop() {}\n");
  EXPECT_THAT(build_here("My").messages,
              HasSubstr("My.ino:3: warning: pinMode(40, …): the uno has no pin 40"));
}

TEST_F(PinWarningsOf, ASketchNameThePinOfAnInterruptOnEachTargetAndBoard) {
  write("My/My.ino",
        "#define ENCODER 4\nvoid tick() {}\nvoid setup() {\n"
        "  attachInterrupt(digitalPinToInterrupt(ENCODER), tick, CHANGE);\n}\nvoid loop() {}\n");
  for (const auto& [board, target] : {std::pair("uno", "host"), {"uno", "avr"}, {"mega", "avr"}})
    EXPECT_THAT(build({folder_ / "My", *find_board(board), target}).messages,
                HasSubstr("My.ino:4: warning: attachInterrupt(digitalPinToInterrupt(4), …): pin D4 of the " +
                          std::string(board) + " has no external interrupt"))
        << board << " " << target;
  EXPECT_EQ(build({folder_ / "My", *find_board("bluepill"), "host"}).messages, "");
}

}  // namespace pin_warnings_test
}  // namespace robosim::build
