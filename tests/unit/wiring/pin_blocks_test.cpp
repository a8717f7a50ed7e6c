#include "sim/campaign/wiring/pin_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/campaign/wiring/sketch_names.h"

namespace robosim::wiring {
namespace pin_blocks_test {

using testing::ElementsAre;

std::vector<PinBlock> blocks(const std::string& source) {
  return names_in_text(source, "a.ino", *find_board("uno")).blocks;
}

constexpr MotorPins kLeft{5, 7, 8}, kRight{6, 9, 10};
const std::string kPins = "const int ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;\n";

TEST(Blocks, HaveTheConditionsOfTheirBranches) {
  const auto found =
      blocks_of(tokens_of("void f(int speed) { if (a) x(); else if (b) { y(); } else z(); w(); }"));
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].conditions.size(), 1u);
  EXPECT_EQ(found[1].conditions.size(), 2u);
  EXPECT_TRUE(found[1].conditions[0].is_negated);
  EXPECT_FALSE(found[1].conditions[1].is_negated);
  EXPECT_TRUE(found[2].conditions[1].is_negated);
  EXPECT_TRUE(found[3].conditions.empty());
  EXPECT_THAT(found[3].parameters, ElementsAre("speed"));
}

TEST(Blocks, AnUnfinishedSourceIsReadAsFarAsItGoes) {
  for (const char* text : {"", "f(", "void f() {", "void f() { if", "void f() { if (a", "void f() { if (a) {",
                           "void f() { case", "void f() { else", "}{", "f(){ switch(a) { case 1: case 2",
                           "void f() { digitalWrite(", "int a[] = {"})
    blocks_of(tokens_of(text));
}

TEST(Forward, IsWhatAFunctionOfThisNameDrives) {
  const auto found = blocks(kPins +
                            "void avanzar() { digitalWrite(IN1, LOW); digitalWrite(IN2, HIGH); }\n"
                            "void farword_Right() { digitalWrite(IN3, HIGH); digitalWrite(IN4, LOW); }\n"
                            "void geri() { digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); }\n");
  EXPECT_EQ(forward_in_blocks(found, kLeft), -1);
  EXPECT_EQ(forward_in_blocks(found, kRight), 1);
}

TEST(Forward, IsWhatAPositiveSpeedDrives) {
  const auto found = blocks(kPins +
                            "void drive(int left, int error) {\n"
                            "  if (left >= 0) { digitalWrite(IN1, LOW); digitalWrite(IN2, HIGH); }\n"
                            "  else { digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); }\n"
                            "  if (error > 0) { digitalWrite(IN3, HIGH); digitalWrite(IN4, LOW); }\n"
                            "  else { digitalWrite(IN3, LOW); digitalWrite(IN4, HIGH); }\n}\n");
  EXPECT_EQ(forward_in_blocks(found, kLeft), -1);
  EXPECT_EQ(forward_in_blocks(found, kRight), 0) << "the sign of an error is no direction";
}

TEST(Forward, IsTheOnlyWayThatAMotorTurns) {
  EXPECT_EQ(forward_in_blocks(
                blocks(kPins + "void loop() { digitalWrite(IN1, LOW); digitalWrite(IN2, HIGH); }"), kLeft),
            -1);
  EXPECT_EQ(forward_in_blocks(
                blocks(kPins + "void loop() { digitalWrite(IN1, a); digitalWrite(IN2, HIGH); }"), kLeft),
            0);
}

TEST(Forward, IsKnownThroughParametersAndValues) {
  const auto found =
      blocks(kPins +
             "void motor(byte pwm, byte a, byte b, int v) { digitalWrite(a, v < 0); digitalWrite(b, v "
             "> 0 ? HIGH : LOW); analogWrite(pwm, abs(v)); }\n"
             "void loop() { motor(ENA, IN1, IN2, 90); motor(ENB, IN4, IN3, 90); }\n");
  EXPECT_EQ(forward_in_blocks(found, kLeft), -1);
  EXPECT_EQ(forward_in_blocks(found, kRight), 1);
  EXPECT_EQ(forward_in_blocks(blocks(kPins + "int d = 1;\nvoid loop() { d = 0; digitalWrite(IN1, d); "
                                             "digitalWrite(IN2, LOW); }"),
                              kLeft),
            0)
      << "d is a variable";
}

TEST(SideOfAPin, IsNamedByACommentAValueAConditionOrAFunction) {
  const auto found = blocks(kPins +
                            "void set(int izq, int der) {\n"
                            "  analogWrite(ENB, izq);\n"
                            "  if (der >= 0) { digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); }\n"
                            "  digitalWrite(IN3, HIGH);  // rueda izquierda\n}\n"
                            "void rightF(int v) { digitalWrite(4, HIGH); digitalWrite(2, LOW); }\n"
                            "void turnLeft() { analogWrite(ENA, 0); }\n");
  EXPECT_EQ(side_in_blocks(found, 6), Side::left) << "the value";
  EXPECT_EQ(side_in_blocks(found, 7), Side::right) << "the condition";
  EXPECT_EQ(side_in_blocks(found, 9), Side::left) << "the comment";
  EXPECT_EQ(side_in_blocks(found, 4), Side::right) << "the function";
  EXPECT_EQ(side_in_blocks(found, 5), Side::unknown);
}

TEST(Order, OfTheMotorsFollowsFromTurns) {
  const std::string turn =
      kPins +
      "void sola() { digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); analogWrite(ENA, 200);\n"
      "  digitalWrite(IN3, HIGH); digitalWrite(IN4, LOW); analogWrite(ENB, 80); }\n";
  EXPECT_EQ(order_in_blocks(blocks(turn), kLeft, kRight, 1, 1), -1) << "the faster wheel is at the right";
  EXPECT_EQ(order_in_blocks(blocks(turn), kRight, kLeft, 1, 1), 1);
  EXPECT_EQ(order_in_blocks(blocks(turn), kLeft, kRight, 0, 0), 0) << "without directions, nothing is known";
  EXPECT_EQ(
      order_in_blocks(blocks(kPins + "void frente1() { digitalWrite(IN1, HIGH); digitalWrite(IN2, LOW); }\n"
                                     "void tras2() { digitalWrite(IN3, LOW); digitalWrite(IN4, HIGH); }\n"
                                     "void direita() { frente1(); tras2(); }\n"),
                      kLeft, kRight, 1, 1),
      1)
      << "the turn calls other functions";
}

}  // namespace pin_blocks_test
}  // namespace robosim::wiring
