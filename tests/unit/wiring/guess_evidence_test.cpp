// Tests guesses of the wiring from evidence other than the pins' names: comments, functions, loops and
// interrupts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/campaign/wiring/draft.h"
#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {
namespace guess_evidence_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Returns the robot file that is guessed from the calls in the source, without a run.
std::string guessed(const std::string& source, const char* board = "uno") {
  const BoardSpec& spec = *find_board(board);
  return text_of(guess(spec, names_in_text(source, "a.ino", spec), PinHistory(spec), {}));
}

TEST(GuessMotors, PinIsAWordOfItsOwn) {
  const std::string text = guessed(
      "#define PINENA 3\n#define PININ1 2\n#define PININ2 4\n#define PINENB 6\n#define PININ3 5\n#define "
      "PININ4 7\n"
      "void f() { analogWrite(PINENA, v); digitalWrite(PININ1, 1); digitalWrite(PININ2, 0); "
      "analogWrite(PINENB, v); digitalWrite(PININ3, 1); digitalWrite(PININ4, 0); }");
  EXPECT_THAT(text,
              AllOf(HasSubstr("{ en = 3, in1 = 2, in2 = 4 }"), HasSubstr("{ en = 6, in1 = 5, in2 = 7 }")));
}

TEST(GuessMotors, TheLettersOfALanguageAreSides) {
  EXPECT_THAT(guessed("#define PIN_SENS_AVANCE_G 2\n#define PIN_SENS_ARRIERE_G 4\n#define PIN_EN_G 3\n"
                      "#define PIN_SENS_AVANCE_D 7\n#define PIN_SENS_ARRIERE_D 8\n#define PIN_EN_D 5\n"
                      "void f() { analogWrite(PIN_EN_G, v); digitalWrite(PIN_SENS_AVANCE_G, 1); "
                      "digitalWrite(PIN_SENS_ARRIERE_G, 0); analogWrite(PIN_EN_D, v); "
                      "digitalWrite(PIN_SENS_AVANCE_D, 1); digitalWrite(PIN_SENS_ARRIERE_D, 0); }"),
              AllOf(HasSubstr("{ en = 3, in1 = 2, in2 = 4 }"), HasSubstr("{ en = 5, in1 = 7, in2 = 8 }"),
                    Not(HasSubstr("which motor is the left one"))));
  EXPECT_THAT(guessed("int M_E1 = 8, M_E2 = 7, M_EV = 6, M_DV = 5, M_D1 = 3, M_D2 = 4;\n"
                      "void f() { analogWrite(M_EV, v); analogWrite(M_DV, v); digitalWrite(M_E1, a); "
                      "digitalWrite(M_E2, b); digitalWrite(M_D1, a); digitalWrite(M_D2, b); }"),
              AllOf(HasSubstr("{ en = 6, in1 = 8, in2 = 7 }"), HasSubstr("{ en = 5, in1 = 3, in2 = 4 }")));
}

TEST(GuessMotors, FunctionsOfOneSidePairPinsWithoutNames) {
  const std::string text = guessed(
      "void leftF(int v) { digitalWrite(4, HIGH); digitalWrite(2, LOW); analogWrite(6, v); }\n"
      "void rightF(int v) { digitalWrite(8, HIGH); digitalWrite(7, LOW); analogWrite(5, v); }");
  EXPECT_THAT(text,
              AllOf(HasSubstr("{ en = 6, in1 = 4, in2 = 2 }"), HasSubstr("{ en = 5, in1 = 8, in2 = 7 }"),
                    Not(HasSubstr("is guessed from the order"))));
}

TEST(GuessMotors, CommentsNameSidesAndDirections) {
  const std::string text = guessed(
      "void setup() {\n  pinMode(10, OUTPUT);  // moteur droit arrière\n  pinMode(5, OUTPUT);  // moteur "
      "droit avant\n"
      "  pinMode(6, OUTPUT);  // moteur gauche avant\n  pinMode(9, OUTPUT);  // moteur gauche arrière\n}\n"
      "void f() { analogWrite(10, a); analogWrite(5, b); analogWrite(6, c); analogWrite(9, d); }");
  EXPECT_THAT(text, AllOf(HasSubstr("{ in1 = 6, in2 = 9 }"), HasSubstr("{ in1 = 5, in2 = 10 }")));
}

TEST(GuessMotors, TheSideOfAnEnablePinIsThatOfItsChannel) {
  const std::string pins =
      "const int ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;\n"
      "void f() { digitalWrite(IN1, 1); digitalWrite(IN2, 0); digitalWrite(IN3, 1); digitalWrite(IN4, 0);\n";
  const auto right_is_a = AllOf(HasSubstr("name = \"right\"                      # ENA, IN1, IN2"),
                                HasSubstr("name = \"left\"                       # ENB, IN3, IN4"));
  EXPECT_THAT(guessed(pins + "  analogWrite(ENA, speedRight); analogWrite(ENB, speedLeft); }"), right_is_a);
  EXPECT_THAT(guessed(pins + "  analogWrite(ENA, velDer); analogWrite(ENB, v); }"), right_is_a);
  EXPECT_THAT(guessed(pins + "  analogWrite(ENA, speedRight); analogWrite(ENB, turnRight); }"),
              HasSubstr("which motor is the left one is guessed"));
}

TEST(GuessMotors, ContradictoryFunctionsLeaveTheSidesOpen) {
  const std::string pins =
      "const int ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;\n"
      "void forward() { digitalWrite(IN1, 1); digitalWrite(IN2, 0); digitalWrite(IN3, 1); digitalWrite(IN4, "
      "0); }\n"
      "void right() { digitalWrite(IN1, 0); digitalWrite(IN2, 1); digitalWrite(IN3, 1); digitalWrite(IN4, "
      "0);\n";
  EXPECT_THAT(guessed(pins + "  analogWrite(ENA, v); analogWrite(ENB, v); }"),
              AllOf(HasSubstr("name = \"right\"                      # ENA, IN1, IN2"),
                    Not(HasSubstr("which motor is the left one"))))
      << "the wheel that turns back is at the right";
  EXPECT_THAT(guessed(pins + "  analogWrite(ENA, leftSpeed); analogWrite(ENB, rightSpeed); }"),
              HasSubstr("which motor is the left one is guessed"));
}

TEST(GuessMotors, FunctionsThatNothingCallsDoNotOutweighThoseThatRun) {
  const std::string pins = "const int ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;\n";
  const auto drive = [](const char* name, int a, int b) {
    return fmt::format(
        "void {}() {{ digitalWrite(IN1, {}); digitalWrite(IN2, {}); digitalWrite(IN3, {}); digitalWrite(IN4, "
        "{}); analogWrite(ENA, v); analogWrite(ENB, v); }}\n",
        name, a, 1 - a, b, 1 - b);
  };
  const std::string loop = "void loop() { forward(); left(); }\n";
  const auto runs = pins + loop + drive("forward", 0, 0) + drive("left", 1, 0);
  EXPECT_THAT(guessed(runs + drive("goForward", 1, 1)), HasSubstr("{ en = 5, in1 = 8, in2 = 7 }"))
      << "the directions";
  EXPECT_THAT(guessed(runs + drive("turnLeft", 0, 1)),
              AllOf(HasSubstr("name = \"left\"                       # ENA, IN2, IN1"),
                    Not(HasSubstr("which motor is the left one"))))
      << "the sides";
  EXPECT_THAT(guessed(pins +
                      "void loop() { go(); }\nvoid go() { analogWrite(ENA, speedRight); analogWrite(ENB, "
                      "speedLeft); }\nvoid test() { analogWrite(ENA, speedLeft); analogWrite(ENB, "
                      "speedRight); }\n" +
                      drive("spin", 1, 0)),
              HasSubstr("name = \"right\"                      # ENA, IN1, IN2"))
      << "the sides of values";
}

TEST(GuessMotors, ACommentThatHighStopsAMotorIsAskedFor) {
  const std::string pins = "#define motor1 5\n#define motor2 9\n";
  EXPECT_THAT(guessed(pins + "void f() {\n  digitalWrite(motor1, HIGH);  // DESLIGA MOTOR 1\n"
                             "  digitalWrite(motor2, HIGH);  // apaga el motor 2\n}"),
              HasSubstr("# ? a comment says that HIGH stops this motor"));
  EXPECT_THAT(
      guessed(pins + "void f() {\n  digitalWrite(motor1, LOW);  // off\n  digitalWrite(motor2, LOW);\n}"),
      Not(HasSubstr("HIGH stops")));
}

TEST(GuessSensors, ALoopReadsASeries) {
  EXPECT_THAT(guessed("#define N 5\n#define FIRST A0\nvoid f() { for (int i = 0; i < N; i++) "
                      "v[i] = analogRead(FIRST + i); }"),
              HasSubstr("pins = [\"A0\", \"A1\", \"A2\", \"A3\", \"A4\"]"));
  EXPECT_THAT(guessed("void f() { for (byte pin = 2; pin <= 6; pin++) digitalRead(pin); }"),
              HasSubstr("pins = [2, 3, 4, 5, 6]"));
  EXPECT_THAT(guessed("void f() { for (byte pin = 2; pin <= last(); pin++) digitalRead(pin); }"),
              Not(HasSubstr("pins = [")));
}

TEST(GuessSensors, ReadingsThatFillAnArrayAreInItsOrder) {
  EXPECT_THAT(guessed("const int leftIR = 4;\nvoid f() { v[0] = analogRead(A3); v[1] = analogRead(A1); "
                      "v[2] = analogRead(A2); bool end = digitalRead(leftIR); }"),
              AllOf(HasSubstr("pins = [\"A3\", \"A1\", \"A2\"]"), HasSubstr("# ? pin 4 (leftIR")));
}

TEST(GuessSensors, OneOrTwoPlacesInCommentsOrientASeries) {
  const std::string reads =
      "void f() { digitalRead(s1); digitalRead(s2); digitalRead(s3); digitalRead(s4); }";
  EXPECT_THAT(guessed("#define s1 2  // o 1o da direita\n#define s2 3\n#define s3 4\n#define s4 5  // mais a "
                      "esquerda\n" +
                      reads),
              AllOf(HasSubstr("pins = [5, 4, 3, 2]"), Not(HasSubstr("the order from left to right"))));
  EXPECT_THAT(guessed("#define s1 2\n#define s2 3\n#define s3 4\n#define s4 5  // ganz links\n" + reads),
              HasSubstr("pins = [5, 4, 3, 2]"));
  EXPECT_THAT(guessed("#define s1 2\n#define s2 3  // links\n#define s3 4\n#define s4 5\n" + reads),
              HasSubstr("# ? the order from left to right is guessed"));
}

TEST(GuessMotors, ARobotThatTurnsBothWaysShowsNoDirection) {
  const BoardSpec& uno = *find_board("uno");
  PinHistory history(uno);
  const auto level = [&](std::int64_t t_s, const char* pin, bool high) {
    history.add(wire::PinChange{t_s * 1'000'000'000, pin, "output", high});
  };
  level(0, "D7", true);
  level(0, "D8", false);
  level(0, "D9", true);
  level(0, "D10", false);
  level(4, "D7", false);
  level(4, "D8", true);
  history.end(10'000'000'000);
  const std::string source =
      "const int LM1 = 7, LM2 = 8, RM1 = 9, RM2 = 10;\nvoid f() { digitalWrite(LM1, a); "
      "digitalWrite(LM2, b); digitalWrite(RM1, c); digitalWrite(RM2, d); }";
  EXPECT_THAT(text_of(guess(uno, names_in_text(source, "a.ino", uno), history, {})),
              Not(HasSubstr("reversed = ")));
}

TEST(GuessSensors, OneSeriesStaysTogether) {
  EXPECT_THAT(guessed("enum Pins { SENSOR_D0 = 11, SENSOR_A1 = A5, SENSOR_A2 = A4, SENSOR_D3 = 12 };\n"
                      "void f() { digitalRead(SENSOR_D0); digitalRead(SENSOR_D3); analogRead(SENSOR_A1); "
                      "analogRead(SENSOR_A2); }"),
              HasSubstr("read = \"digital\"\npins = [11, \"A5\", \"A4\", 12]"));
  EXPECT_THAT(guessed("#define ee A4\n#define e A3\n#define c A2\n#define d A1\n#define dd A0\n"
                      "void f() { int EE = analogRead(ee), E = analogRead(e), C = analogRead(c), D = "
                      "analogRead(d), DD = analogRead(dd); }"),
              HasSubstr("pins = [\"A4\", \"A3\", \"A2\", \"A1\", \"A0\"]"));
}

TEST(GuessSensors, TheSourceStatesTheLevelOverBlack) {
  const std::string reads =
      "const int s[] = {A0, A1, A2};\nvoid f() { analogRead(s[0]); analogRead(s[1]); "
      "analogRead(s[2]); }\n";
  EXPECT_THAT(guessed("#define PRETO LOW\n" + reads),
              AllOf(HasSubstr("black = \"low\"\n# LOW over black: PRETO LOW, a.ino:1"),
                    Not(HasSubstr("HIGH over black is guessed"))));
}

TEST(GuessInputs, AnInterruptThatOnlySetsAFlagIsAButton) {
  const std::string setup =
      "#define STOP_PIN 2\nvoid setup() { pinMode(STOP_PIN, INPUT_PULLUP); "
      "attachInterrupt(digitalPinToInterrupt(STOP_PIN), hit, FALLING); }\nvoid f() { digitalRead(STOP_PIN); "
      "}\n";
  const BoardSpec& uno = *find_board("uno");
  PinHistory history(uno);
  history.add(wire::PinChange{0, "D2", "input_pullup"});
  history.add(wire::LevelSeen{1, "D2", true});
  history.end(1000);
  const auto text = [&](const std::string& source) {
    return text_of(guess(uno, names_in_text(source, "a.ino", uno), history, {}));
  };
  EXPECT_THAT(text(setup + "void hit() { stopped = true; }"), HasSubstr("type = \"button\"\npin = 2"));
  EXPECT_THAT(text(setup + "void hit() { ticks++; }"), HasSubstr("type = \"encoder\""));
}

TEST(GuessLibraries, TheLatchIsThePinAroundShiftOut) {
  EXPECT_THAT(guessed("#define stby 8\nvoid f() { digitalWrite(stby, HIGH); }\n"
                      "void show(int n) { digitalWrite(3, LOW); shiftOut(4, 2, MSBFIRST, n); digitalWrite(3, "
                      "HIGH); }"),
              HasSubstr("{ data = 4, clock = 2, latch = 3 }"));
}

}  // namespace guess_evidence_test
}  // namespace robosim::wiring
