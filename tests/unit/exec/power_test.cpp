// Tests power cycles, the EEPROM and the start of a sketch on the host.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec {
namespace power_test {

using testing::ElementsAre;

using PowerTest = HostTest;

TEST_F(PowerTest, EveryPowerCycleBeginsWithFreshVariables) {
  start(R"(int count; int preset = 5; String text = "a";
void setup() { Serial.begin(115200); ++count; ++preset; text += "b"; static int inner = 3; ++inner; Serial.print(count); Serial.print(preset); Serial.print(inner); Serial.println(text); }
void loop() {})");
  run(20 * kMillisecond);
  host_->power_off(now_);
  run(20 * kMillisecond);
  host_->power_on(now_);
  run(20 * kMillisecond);
  EXPECT_EQ(serial_, "164ab\r\n164ab\r\n");
}

TEST_F(PowerTest, TheEepromSurvives) {
  start(R"(#include <EEPROM.h>
void setup() { Serial.begin(115200); Serial.println(EEPROM.read(3)); EEPROM.write(3, EEPROM.read(3) - 100); }
void loop() {})");
  run(20 * kMillisecond);
  host_->power_on(now_);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(255, 155));
  EXPECT_EQ(host_->probe().memory()[3], 55);
}

TEST_F(PowerTest, AnEepromWriteTakes3400Microseconds) {
  output(R"(#include <EEPROM.h>
void setup() {
  Serial.begin(115200);
  const unsigned long start = micros();
  for (int i = 0; i < 10; ++i) EEPROM.write(i, i);
  Serial.println(micros() - start);
}
void loop() {})");
  ASSERT_EQ(numbers().size(), 1u);
  EXPECT_NEAR(static_cast<double>(numbers()[0]), 9 * 3400, 200);
}

TEST_F(PowerTest, TheEepromIsTheBoardsAlsoWhileTheSketchRuns) {
  struct Watcher final : EepromWatcher {
    void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override {
      heard = {address, before, value};
      at = t;
    }
    std::vector<int> heard;
    SimTime at = 0;
  } watcher;
  start(R"(#include <EEPROM.h>
void setup() { Serial.begin(115200); delay(5); EEPROM.write(9, 7); Serial.println(EEPROM.read(9)); delay(10); Serial.println(EEPROM.read(9)); }
void loop() {})");
  board().watch_eeprom(watcher);
  run(12 * kMillisecond);
  EXPECT_THAT(watcher.heard, ElementsAre(9, 255, 7));
  EXPECT_NEAR(static_cast<double>(watcher.at), 5e6, 1e6);
  host_->probe().memory()[9] = 42;
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(7, 42));
}

TEST_F(PowerTest, AFastClockShowsInEverythingTheSketchTimes) {
  start(
      R"(void setup() { Serial.begin(115200); pinMode(13, OUTPUT); digitalWrite(13, HIGH); delay(1000); digitalWrite(13, LOW); }
void loop() { digitalWrite(13, !digitalRead(13)); delay(100); })");
  host_->set_clock_drift(100'000, 0);
  run(kSecond);
  const std::vector<SimTime> fast = changes(13);
  ASSERT_GE(fast.size(), 3u);
  EXPECT_NEAR(static_cast<double>(fast[2] - fast[1]), 1e9 / 1.1, 2e6);
  host_->set_clock_drift(0, now_);
  const SimTime right = now_;
  run(kSecond);
  const std::vector<SimTime> all = changes(13);
  EXPECT_NEAR(static_cast<double>(all[all.size() - 1] - all[all.size() - 2]), 1e8, 2e6);
  EXPECT_GT(all.back(), right);
  EXPECT_EQ(host_->last_call(), now_);
}

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

TEST_F(PowerTest, SwitchedOffAllPinsAreInputsAndNothingRuns) {
  start("void setup() { pinMode(13, OUTPUT); } void loop() { digitalWrite(13, !digitalRead(13)); }");
  run(kMillisecond);
  host_->power_off(now_);
  EXPECT_EQ(board().drive(13), PinDrive{});
  const std::size_t before = pins_.size();
  run(10 * kMillisecond);
  EXPECT_EQ(pins_.size(), before);
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

TEST_F(PowerTest, ASketchMayHaveItsOwnMain) {
  start(
      "int main() { init(); pinMode(13, OUTPUT); for (;;) { digitalWrite(13, HIGH); delay(1); "
      "digitalWrite(13, LOW); delay(1); } }\nvoid setup() {}\nvoid loop() {}");
  run(20 * kMillisecond);
  EXPECT_GT(changes(13).size(), 15u);
}

TEST_F(PowerTest, ASketchsOwnYieldIsCalledDuringDelay) {
  start(
      "volatile long n; void yield() { ++n; }\nvoid setup() { Serial.begin(115200); delay(10); "
      "Serial.println(n > 500); }\nvoid loop() {}");
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1));
}

}  // namespace power_test
}  // namespace robosim::exec
