// Tests divisions by zero and overflows. A sketch on the host continues with the result that its chip would
// compute (sim/build/division.h). tests/system/targets_test.cpp compares the results with the emulated AVR.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::division_test {

using testing::ElementsAre;

class DivisionTest : public HostTest {
 protected:
  /// Returns the quotient and the remainder of `dividend` / `divisor`, as a sketch computes them in `type`.
  std::vector<long long> divided(const std::string& type, const std::string& dividend,
                                 const std::string& divisor = "0") {
    serial_.clear();
    output("volatile " + type + " a = " + dividend + ", b = " + divisor +
           ";\nvoid setup() {\n"
           "  Serial.begin(115200);\n  " +
           type +
           " q = a / b, r = a % b;\n"
           "  Serial.println(q); Serial.println(r);\n}\nvoid loop() {}\n");
    return numbers();
  }
};

TEST_F(DivisionTest, ByZeroGivesAllOnesAndTheDividendAsAnAvrDoes) {
  for (const char* type : {"int16_t", "int32_t"}) {
    EXPECT_THAT(divided(type, "10"), ElementsAre(-1, 10)) << type;
    EXPECT_THAT(divided(type, "0"), ElementsAre(-1, 0)) << type;
    EXPECT_THAT(divided(type, "-10"), ElementsAre(1, -10)) << type;
  }
  EXPECT_THAT(divided("uint8_t", "10"), ElementsAre(255, 10));
#if !defined(__aarch64__)  // sim/build/division.h explains this exception
  EXPECT_THAT(divided("uint16_t", "10"), ElementsAre(65535, 10));
#endif
  EXPECT_THAT(divided("uint32_t", "10"), ElementsAre(4294967295, 10));
}

TEST_F(DivisionTest, ByZeroGivesZeroAndTheDividendAsACortexDoes) {
  board_name_ = "bluepill";
  EXPECT_THAT(divided("int32_t", "10"), ElementsAre(0, 10));
  EXPECT_THAT(divided("int32_t", "-10"), ElementsAre(0, -10));
  EXPECT_THAT(divided("uint16_t", "10"), ElementsAre(0, 10));
}

TEST_F(DivisionTest, TheMostNegativeNumberByMinusOneIsItself) {
  EXPECT_THAT(divided("int32_t", "-2147483648", "-1"), ElementsAre(-2147483648ll, 0));
  EXPECT_THAT(divided("int16_t", "7", "-1"), ElementsAre(-7, 0));
}

TEST_F(DivisionTest, OtherDivisionsAreAsEver) {
  EXPECT_THAT(divided("int16_t", "-100", "7"), ElementsAre(-14, -2));
  EXPECT_THAT(divided("uint8_t", "200", "7"), ElementsAre(28, 4));
  EXPECT_THAT(divided("uint32_t", "4000000000", "7"), ElementsAre(571428571, 3));
  EXPECT_TRUE(host_->divisions_by_zero().empty());
}

TEST_F(DivisionTest, AnEmptyRangeOfMapGivesWhatItGivesOnTheChip) {
  output(
      "volatile int zero;\nvoid setup() {\n  Serial.begin(115200);\n"
      "  Serial.println(map(500, zero, zero, 10, 90));\n  Serial.println(map(-500, zero, zero, 10, 90));\n"
      "}\nvoid loop() {}\n");
  EXPECT_THAT(numbers(), ElementsAre(9, 11));
  ASSERT_EQ(host_->divisions_by_zero().size(), 2u);
  EXPECT_EQ(host_->divisions_by_zero()[0].where.line, 4);
}

TEST_F(DivisionTest, ItIsToldWhereAndHowOftenTheSketchDividedByZero) {
  output(
      "volatile int zero, n;\nint mean(int sum) { return sum / zero; }\nvoid setup() {\n  delay(5);\n"
      "  for (int i = 0; i < 7; i++) n += mean(i);\n}\nvoid loop() { delay(300); n = 5 % zero; }\n");
  const auto& all = host_->divisions_by_zero();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].where.function, "mean");
  EXPECT_EQ(all[0].where.file, "Test.ino");
  EXPECT_EQ(all[0].where.line, 2);
  EXPECT_EQ(all[0].times, 7);
  EXPECT_NEAR(all[0].first_s, 0.005, 0.001);
  EXPECT_EQ(all[1].where.line, 7);
  EXPECT_EQ(all[1].times, 3);
}

TEST_F(DivisionTest, AfterAPowerCutTheCountGoesOn) {
  start("volatile int zero, n;\nvoid setup() { n = 5 / zero; }\nvoid loop() {}\n");
  run(kSecond);
  host_->power_on(now_);
  run(kSecond);
  ASSERT_EQ(host_->divisions_by_zero().size(), 1u);
  EXPECT_EQ(host_->divisions_by_zero()[0].times, 2);
}

TEST_F(DivisionTest, ManyLinesThatDivideByZeroAreToldAsTheFirstEight) {
  std::string text = "volatile int zero, n;\nvoid setup() {\n";
  for (int i = 0; i < 20; ++i) text += "  n = 5 / zero;\n";
  start(text + "}\nvoid loop() {}\n");
  run(kSecond);
  EXPECT_FALSE(host_->crash());
  EXPECT_EQ(host_->divisions_by_zero().size(), 8u);
}

}  // namespace robosim::exec::division_test
