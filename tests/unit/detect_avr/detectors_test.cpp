// Tests which programs the detectors of target avr report, and which programs they accept.
#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::detectors_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using DetectorsTest = AvrDetectorTest;

TEST_F(DetectorsTest, AFloatThatPassesANumberByTheNumbersLine) {
  const std::string sketch =
      "volatile float angle, left = 1, passed;\n"
      "void setup() {}\n"
      "void loop() {\n"
      "  for (angle = 0; angle != 90.0; angle += 0.7)\n"  // line 4
      "    if (angle > 95) break;\n"
      "  left -= 0.1;\n"
      "  if (left == 0) passed = 1;\n"  // line 7
      "}\n";
  const auto found = found_in(sketch, 100 * kMillisecond);
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].detector, "float_equality");
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_THAT(found[0].what, HasSubstr("by == or != with 90"));
  EXPECT_GT(found[0].times, 130);
  EXPECT_EQ(found[1].where.line, 7);
  avr_->power_off(now_);
  EXPECT_THAT(avr_->detected(), SizeIs(2)) << "findings stay after power-off";
  watched_ = false;
  EXPECT_THAT(found_in(sketch, 100 * kMillisecond), IsEmpty());
}

TEST_F(DetectorsTest, WhatIsMetOrOnlySparesAStepOrWatchesForAChangeIsNone) {
  EXPECT_THAT(found_in("volatile float x, last = 5, error = 0.5, sign = -0.9, n, big;\n"
                       "void setup() {}\n"
                       "void loop() {\n"
                       "  x += 0.25;\n"
                       "  if (x == 10.0) n = 1;\n"                   // becomes equal once
                       "  if (x != last) last = x + 0.01 * sign;\n"  // detects a change
                       "  error *= sign; sign = -sign;\n"            // changes its sign
                       "  if (error == 0) n = 2;\n"
                       "  if (error < 0.1 && x > 3.3) n = 3;\n"  // does not compare for equality
                       "  big = 400.5;\n"
                       "  if (big == 400) n = 4;\n"  // never crosses the number
                       "}\n",
                       50 * kMillisecond),
              IsEmpty());
}

TEST_F(DetectorsTest, AnalogWriteOnAPinOutOfAnArrayThatHasNoPwm) {
  const auto found = found_in(
      "const byte motors[] = {5, 7};\n"
      "volatile int speed = 100;\n"
      "void setup() { analogWrite(8, 255); analogWrite(12, speed - 100); }\n"
      "void loop() {\n"
      "  for (byte i = 0; i < 2; i++)\n"
      "    analogWrite(motors[i], speed);\n"  // line 6
      "  delay(10);\n"
      "}\n",
      95 * kMillisecond);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "lost_pwm");
  EXPECT_EQ(found[0].where.line, 6);
  EXPECT_EQ(found[0].times, 10);
  EXPECT_EQ(found[0].what,
            "pin 7 of the uno has no PWM, and is LOW for values below 128, and HIGH otherwise: "
            "analogWrite(7, 100)");
  EXPECT_EQ(found[0].mend, "Use a pin with PWM: 3, 5, 6, 9, 10, 11.");
}

TEST_F(DetectorsTest, TheFirstReadingBehindEachChangeOfTheReference) {
  const std::string begin =
      "volatile int battery, left;\n"
      "void setup() {}\n"
      "void loop() {\n"
      "  analogReference(INTERNAL);\n";
  const auto found = found_in(begin +
                                  "  battery = analogRead(A5);\n"  // line 5
                                  "  analogReference(DEFAULT);\n"
                                  "  left = analogRead(A0);\n"
                                  "  delay(1);\n"
                                  "}\n",
                              50 * kMillisecond);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "reference_change");
  EXPECT_TRUE(found[0].where.line == 5 || found[0].where.line == 7) << found[0].where.line;
  EXPECT_THAT(found[0].what, HasSubstr("analogRead(A"));

  EXPECT_THAT(found_in(begin + "  analogRead(A5); battery = analogRead(A5);\n"
                               "  analogReference(DEFAULT);\n"
                               "  analogRead(A0); left = analogRead(A0);\n"
                               "  left = analogRead(A1);\n"
                               "}\n",
                       50 * kMillisecond),
              IsEmpty());
}

}  // namespace robosim::detect::detectors_test
