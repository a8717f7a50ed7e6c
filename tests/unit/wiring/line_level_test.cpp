#include "sim/campaign/wiring/line_level.h"

#include <gtest/gtest.h>

#include "sim/campaign/wiring/sketch_names.h"

namespace robosim::wiring {
namespace line_level_test {

// Returns the level over black that a source states, as "HIGH", "LOW" or "".
std::string level(const std::string& source) {
  const auto stated = names_in_text(source, "a.ino", *find_board("uno")).level;
  return !stated ? "" : stated->is_high ? "HIGH" : "LOW";
}

TEST(LineLevel, ConstantsNameTheLevelOfAColourOrOfTheLine) {
  EXPECT_EQ(level("#define NEGRO LOW\n#define BLANCO HIGH\n"), "LOW");
  EXPECT_EQ(level("const int SCHWARZ = 1;\n"), "HIGH");
  EXPECT_EQ(level("enum { siyah = 0, beyaz = 1 };\n"), "LOW");
  EXPECT_EQ(level("#define SENSOR_NIVEL_FAIXA LOW\n"), "LOW");
  EXPECT_EQ(level("#define LINE_LOGIC 1\n"), "") << "a number may be a mode";
  EXPECT_EQ(level("#define WHITE_LED 1\n"), "") << "a colour of a lamp";
  EXPECT_EQ(level("int black = 0;\nvoid loop() { black = black + 1; }\n"), "") << "a counter";
}

TEST(LineLevel, VariablesAndFunctionsNamedAfterAColourAreSetByAComparison) {
  EXPECT_EQ(level("void loop() { bool leftBlack = (leftV >= threshold); }\n"), "HIGH");
  EXPECT_EQ(level("void loop() { bool noirGauche = analogRead(A0) < 300; }\n"), "LOW");
  EXPECT_EQ(level("bool estaEnNegro(int pin) { if (analogRead(pin) < 50) return true; return false; }\n"),
            "LOW");
  EXPECT_EQ(level("bool isWhite(int pin) { return digitalRead(pin) == LOW; }\n"), "HIGH");
  EXPECT_EQ(
      level("Colour see(int pin) { switch (digitalRead(pin)) { case HIGH: return kWhite; case LOW: return "
            "kBlack; } }\n"),
      "LOW");
  EXPECT_EQ(level("void loop() { int lineLeft = digitalRead(2); }\n"), "") << "a name alone states no level";
}

TEST(LineLevel, CommentsStateTheLevelInSeveralLanguages) {
  EXPECT_EQ(level("// HIGH = black, LOW = white\n"), "HIGH");
  EXPECT_EQ(level("// el sensor da 0 sobre negro y 1 sobre blanco\n"), "LOW");
  EXPECT_EQ(level("// LOW: auf schwarz\n"), "LOW");
  EXPECT_EQ(level("/* beyaz 0, siyah 1 */\n"), "HIGH");
  EXPECT_EQ(level("// sensor 1 is over the black tape\n"), "") << "the number of a sensor";
  EXPECT_EQ(level("// 1 1 0 0 0   black\n"), "") << "a table of readings";
  EXPECT_EQ(level("// led HIGH on black\n"), "");
  EXPECT_EQ(level("// black: stop, motors 0 0\n// line search, 70 0\n"), "") << "numbers of something else";
}

TEST(LineLevel, ABranchStatesTheLevelByItsCommentItsTextOrItsTurn) {
  EXPECT_EQ(level("void loop() { if (digitalRead(2) && digitalRead(4)) { // ambos en blanco\n go(); } }"),
            "LOW");
  EXPECT_EQ(level("void loop() {\n // se o sensor estiver lendo preto\n if (valor == HIGH) { f(); } }"),
            "HIGH");
  EXPECT_EQ(level("void loop() { while (digitalRead(L) == LOW && digitalRead(R) == LOW) { "
                  "Serial.println(\"Lost line!\"); } }"),
            "HIGH");
  const std::string turn = "void loop() { int lsensor = digitalRead(9), rsensor = digitalRead(8);\n";
  EXPECT_EQ(level(turn + "if (lsensor == HIGH && rsensor == LOW) { RIGHT(); } }"), "LOW");
  EXPECT_EQ(level(turn + "if (lsensor == HIGH && rsensor == LOW) { girarIzquierda(); } }"), "HIGH");
  EXPECT_EQ(level(turn + "if (lsensor == HIGH && rsensor == LOW) { blink(); } }"), "");
}

TEST(LineLevel, ContradictionsLeaveTheLevelOpenButCodeOutranksComments) {
  EXPECT_EQ(level("// HIGH = black\n// on black the sensor is LOW\n"), "");
  EXPECT_EQ(level("#define BLACK LOW\n// HIGH = black\n"), "LOW");
  EXPECT_EQ(level("void loop() { int a = !digitalRead(2); }\n"), "LOW");
  EXPECT_EQ(level("void loop() { int a = !digitalRead(2); }\nvoid f() { int a = digitalRead(2); }\n"), "")
      << "two modes";
  EXPECT_EQ(level("// 1 = black line\nvoid loop() { int v = 1023 - analogRead(A0); }\n"), "");
}

TEST(LineLevel, CodeThatNothingCallsDoesNotOutweighCodeThatRuns) {
  const std::string runs =
      "void loop() { follow(); }\nvoid follow() { bool black = digitalRead(2) == LOW; }\n";
  const std::string old =
      "bool isBlack(int pin) { return digitalRead(pin) == HIGH; }\n"
      "void oldLoop() { bool black = digitalRead(2) == HIGH; if (isBlack(3)) oldLoop(); }\n";
  EXPECT_EQ(level(runs + old), "LOW");
  EXPECT_EQ(level(runs + old + "void oldLoop();\n"), "LOW") << "a declaration is no call";
  EXPECT_EQ(level("void loop() { go(); }\n" + old), "HIGH") << "better than nothing";
  EXPECT_EQ(level(old), "HIGH") << "a file without setup() and loop()";
  EXPECT_EQ(level(runs + old + "ISR(TIMER1_OVF_vect) { oldLoop(); }\n"), "");
  EXPECT_EQ(level(runs + old + "Task task(oldLoop);\n"), "") << "a constructor of a global gets the function";
  EXPECT_EQ(level(runs + old + "void setup() { attachInterrupt(0, oldLoop, RISING); }\n"), "");
  EXPECT_EQ(level("void loop() { v = digitalRead(2); // HIGH = black\n}\n"
                  "void test() {\n // LOW = black\n f();\n}\n"),
            "HIGH")
      << "a comment in such code";
}

TEST(LineLevel, ACommentThatStatesAConditionIsNoStatement) {
  EXPECT_EQ(level("int s = 2;  // if the line is black, change this to LOW\n"), "");
  EXPECT_EQ(level("// use HIGH for a white line\n"), "");
  EXPECT_EQ(level("// wenn die Linie schwarz wird, auf LOW setzen\n"), "");
  EXPECT_EQ(level("// para linea negra cambiar HIGH por LOW\n"), "");
  EXPECT_EQ(level("// use HIGH for a white line\nvoid loop() { bool onLine = analogRead(A0) > 500; }\n"),
            "HIGH")
      << "the sketch's line is black";
  EXPECT_EQ(
      level(
          "void loop() {\n // replace HIGH by LOW for a white line\n if (digitalRead(2) == HIGH) { f(); } }"),
      "");
  EXPECT_EQ(level("// the sensor is HIGH if it is on black\n"), "HIGH") << "states what the sensor does";
}

TEST(LineLevel, ACommentOnAComputedValueIsNoStatement) {
  EXPECT_EQ(level("void loop() { int error = r - l;  // > 0: the line is on the right\n}\n"), "");
  EXPECT_EQ(level("void loop() { int x = r - l;  // >= 0 the line is on the right\n}\n"), "");
  EXPECT_EQ(level("void loop() { int error = r - l;  // 0 = on the line\n}\n"), "");
  EXPECT_EQ(level("int lastPosition = 0;  // 0 = black line in the middle\n"), "");
  EXPECT_EQ(level("void loop() { int s = digitalRead(2);  // 0 = on the line\n}\n"), "LOW");
}

TEST(LineLevel, AWhiteLineReversesWhatAFlagMeans) {
  const std::string flag = "void loop() { if (s <= THRESHOLD) p = 1; else p = 0; }\n";
  EXPECT_EQ(level("#define THRESHOLD 700\n" + flag), "LOW");
  EXPECT_EQ(level("#define THRESHOLD 700  // referencia da linha branca\n" + flag), "HIGH");
}

}  // namespace line_level_test
}  // namespace robosim::wiring
