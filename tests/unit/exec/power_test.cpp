// Tests power cycles, the EEPROM and the start of a sketch on the host.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::power_test {

using testing::ElementsAre;

using PowerTest = HostTest;

TEST_F(PowerTest, ConstructorsOfStaticObjectsRunAtPowerOnAndReachTheBoard) {
  start(R"(struct Led { Led() { pinMode(12, OUTPUT); digitalWrite(12, HIGH); } } led;
void setup() { digitalWrite(12, LOW); }
void loop() {})");
  EXPECT_TRUE(pins_.empty());
  run(kMillisecond);
  ASSERT_EQ(pins_.size(), 3u);
  EXPECT_TRUE(pins_[1].drive.level);
  EXPECT_FALSE(pins_[2].drive.level);
}

// In the library AFMotor, motors are static objects whose constructors connect their pins to timer 2.
TEST_F(PowerTest, InitLeavesTheBitsOfTimersThatConstructorsHaveSet) {
  output(R"(struct Shield {
  Shield() { TCCR1A = 0x80; TCCR1B = 0x10; TCCR2A |= _BV(COM2A1) | _BV(WGM21) | _BV(WGM20); 
             OCR2A = 64; DDRB |= 8; }
} shield;
void setup() {
  Serial.begin(115200);
  Serial.println(TCCR1A); Serial.println(TCCR1B); Serial.println(TCCR2A); Serial.println(TCCR2B);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(0x81, 3, 0x83, 4));
  EXPECT_NEAR(board().drive(11).duty, 65.0 / 256, 1e-6);
}

TEST_F(PowerTest, FirmwareStartsItsClockWhenItIsSwitchedOn) {
  start(
      "void setup() { Serial.begin(115200); Serial.println(millis()); delay(10); Serial.println(millis()); } "
      "void loop() {}",
      100 * kSecond);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 9));  // nine overflows of timer 0 in 10 ms, each of 1.024 ms
  EXPECT_GT(byte_times_[0], 100 * kSecond);
}

TEST_F(PowerTest, TwoRobotsHaveTwoSetsOfVariables) {
  start("int n; void setup() { Serial.begin(115200); } void loop() { Serial.print(n++); delay(10); }");
  HostExecutor second(
      *find_board("uno"),
      build("int n; void setup() { Serial.begin(115200); } void loop() { Serial.print(n++); delay(10); }"));
  second.board().watch_serial(*this);
  second.power_on(0);
  for (int tick = 1; tick <= 35; ++tick) {
    host_->run_until(tick * kTick);
    second.run_until(tick * kTick);
  }
  EXPECT_EQ(serial_, "00112233");
}

TEST_F(PowerTest, ASketchsOwnYieldIsCalledDuringDelay) {
  start(
      "volatile long n; void yield() { ++n; }\nvoid setup() { Serial.begin(115200); delay(10); "
      "Serial.println(n > 500); }\nvoid loop() {}");
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1));
}

}  // namespace robosim::exec::power_test
