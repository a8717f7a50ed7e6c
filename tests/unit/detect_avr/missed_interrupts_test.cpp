// Tests the detection of interrupts that are lost while interrupts are off
// (sim/detect/avr/missed_interrupts.h).

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::missed_interrupts_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LossesTest : public AvrDetectorTest {
 protected:
  LossesTest() { counted_ = {2}; }
  /// Returns the findings for a sketch whose loop() executes the statements `line`. They are on line 4 of the
  /// sketch. Pulses of 0.2 ms arrive at pin 2, one per millisecond.
  std::vector<Detected> seen(const std::string& line, const std::string& handler = "++count;") {
    start("volatile unsigned count; volatile float f = 1;\nvoid pulse() { " + handler +
          " }\nvoid setup() { Serial.begin(115200); attachInterrupt(0, pulse, RISING); }\nvoid loop() { " +
          line + " }\n");
    for (int ms = 0; ms < 60; ++ms) {
      const SimTime t = now_ + 300 * kMicrosecond;
      board().schedule_edge(2, true, t);
      board().schedule_edge(2, false, t + 200 * kMicrosecond);
      run(kMillisecond);
    }
    return avr_->detected();
  }
};

TEST_F(LossesTest, EdgesAndTicksThatComeWhileInterruptsAreOff) {
  const auto found = seen("noInterrupts(); delayMicroseconds(5000); interrupts(); delay(3);");
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].detector, "lost_edge");
  EXPECT_THAT(found[0].what, HasSubstr("an edge at pin 2 was lost"));
  EXPECT_THAT(found[0].what, HasSubstr("because all interrupts, or only this one, were off"));
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_NEAR(static_cast<double>(found[0].times), 60.0 / 8.0 * 4.0, 6.0);
  EXPECT_EQ(found[1].detector, "lost_tick");
  EXPECT_THAT(found[1].what, HasSubstr("millis() lost"));
  EXPECT_NEAR(static_cast<double>(found[1].times), 60.0 / 8.0 * 4.0, 8.0);
}

TEST_F(LossesTest, TicksThatComeWhileAHandlerRuns) {
  const auto found = seen("", "if (++count % 20 == 0) for (int i = 0; i < 300; ++i) f = f * 1.01f;");
  ASSERT_FALSE(found.empty());
  for (const Detected& one : found) EXPECT_THAT(one.what, HasSubstr("handler was"));
  EXPECT_EQ(found.back().where.line, 2);
}

TEST_F(LossesTest, TicksThatComeWhileTwoHandlersRunInTurnAreNotLostToInterruptsThatAreOff) {
  counted_ = {2, 3};
  start(
      "volatile int n;\nvoid tick() { delayMicroseconds(800); n++; }\nvoid tock() { delayMicroseconds(800); "
      "n++; }\n"
      "void setup() { attachInterrupt(0, tick, CHANGE); attachInterrupt(1, tock, CHANGE); }\n"
      "void loop() { for (;;) asm volatile(\"rcall 1f\\nrjmp 2f\\n1: ret\\n2:\"); }\n");
  // Each pin gets two edges, so the handlers run in turn for 3.2 ms. Each burst begins one cycle later than
  // the previous burst.
  for (int burst = 0; burst < 12; ++burst) {
    const SimTime t = now_ + kMillisecond + 62 * burst;
    for (const Pin pin : {2, 3}) {
      board().schedule_edge(pin, true, t);
      board().schedule_edge(pin, false, t + 1000 * kMicrosecond);
    }
    run(8 * kMillisecond);
  }
  const auto found = avr_->detected();
  ASSERT_FALSE(found.empty());
  for (const Detected& one : found) {
    EXPECT_THAT(one.what, HasSubstr("handler was"));
    if (one.detector == "lost_tick") {
      EXPECT_NE(one.where.line, 5) << "loop() does not switch interrupts off";
    }
  }
}

TEST_F(LossesTest, BytesThatComeWhileInterruptsAreOff) {
  start(
      "void setup() { Serial.begin(115200); }\nvoid loop() {\n"
      "  noInterrupts(); delayMicroseconds(1000); interrupts();\n  while (Serial.available()) "
      "Serial.read();\n}\n");
  run(5 * kMillisecond);
  for (int i = 0; i < 100; ++i) board().receive_byte('x', now_);
  run(20 * kMillisecond);
  const auto found = avr_->detected();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].detector, "lost_byte");
  EXPECT_THAT(found[0].what,
              HasSubstr("the chip's receive buffer was full, because all interrupts, or only this one, "
                        "were off"));
  EXPECT_EQ(found[0].where.line, 3);
}

TEST_F(LossesTest, BytesThatComeWhileInterruptsAreOnAreNotLost) {
  start(
      "void setup() { Serial.begin(115200); }\nvoid loop() { while (Serial.available()) Serial.read(); }\n");
  run(5 * kMillisecond);
  for (int i = 0; i < 100; ++i) board().receive_byte('x', now_);
  run(20 * kMillisecond);
  EXPECT_THAT(avr_->detected(), IsEmpty());
}

TEST_F(LossesTest, AreNoneWhereInterruptsAreOffForAMoment) {
  EXPECT_THAT(seen("noInterrupts(); unsigned n = count; interrupts(); Serial.println(n);"), IsEmpty());
  EXPECT_THAT(seen("noInterrupts(); delayMicroseconds(600); interrupts(); delayMicroseconds(100);"),
              IsEmpty())
      << "each handler runs before the next edge";
}

}  // namespace robosim::detect::missed_interrupts_test
