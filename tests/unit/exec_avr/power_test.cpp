// Tests power cycles, resets, sleep and the EEPROM of an emulated AVR.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::power_test {

using testing::ElementsAre;

class PowerTest : public AvrTest {};

TEST_F(PowerTest, AChipKnowsABrownOutFromPowerOn) {
  start(R"(void setup() { Serial.begin(115200); Serial.println(MCUSR); }
void loop() {})");
  run(5 * kMillisecond);
  avr_->power_off(now_);
  avr_->power_recovered(now_);
  run(5 * kMillisecond);
  avr_->power_on(now_);
  run(5 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 4, 1));
}

TEST_F(PowerTest, RamOutlivesABrownOutAndNoPowerOn) {
  start(R"(__attribute__((section(".noinit"))) int kept;
int counted;
void setup() { Serial.begin(115200); Serial.println(kept * 10 + counted); kept += 2; ++counted; }
void loop() {})");
  run(5 * kMillisecond);
  avr_->power_off(now_);
  run(5 * kMillisecond);
  avr_->power_recovered(now_);
  run(5 * kMillisecond);
  avr_->power_recovered(now_);
  run(5 * kMillisecond);
  avr_->power_off(now_);
  avr_->power_on(now_);
  run(5 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 20, 40, 0));
}

TEST_F(PowerTest, TheWatchdogStartsTheSketchAgain) {
  start(R"(#include <avr/wdt.h>
void setup() {
  Serial.begin(115200);
  Serial.println(millis());
  pinMode(13, OUTPUT);
  delay(20);
  if (board_was_reset()) for (;;) delay(10);
  mark();
  wdt_enable(WDTO_30MS);
  for (;;) {}
}
byte* flag() { return (byte*)0x800 - 8; }
bool board_was_reset() { return *flag() == 42; }
void mark() { *flag() = 42; }
void loop() {})");
  run(200 * kMillisecond);
  EXPECT_FALSE(avr_->crash());
  EXPECT_THAT(numbers(), ElementsAre(0, 0))
      << "millis() starts at 0, RAM keeps its content, and the watchdog is off";
  EXPECT_EQ(changes(13).size(), 3u) << "the pin was an input in between";
}

TEST_F(PowerTest, PowerDownStopsTheTimersAndAnEdgeWakesIt) {
  start(R"(#include <avr/sleep.h>
void wake() {}
void setup() {
  Serial.begin(115200);
  attachInterrupt(0, wake, CHANGE);
  set_sleep_mode(SLEEP_MODE_PWR_DOWN);
  sleep_mode();
  Serial.println(millis());
}
void loop() {})");
  run(500 * kMillisecond);
  EXPECT_EQ(serial_, "");
  board().schedule_edge(2, true, now_ + 100);
  run(20 * kMillisecond);
  ASSERT_EQ(numbers().size(), 1u);
  EXPECT_LT(numbers()[0], 3) << "millis() stood still";
}

TEST_F(PowerTest, WhatWasToBeSentIsSentAfterADeepSleep) {
  start(R"(#include <avr/sleep.h>
void wake() {}
void setup() {
  Serial.begin(115200);
  attachInterrupt(0, wake, CHANGE);
  Serial.print("before and after");
  set_sleep_mode(SLEEP_MODE_PWR_DOWN);
  sleep_mode();
}
void loop() {})");
  run(100 * kMillisecond);
  EXPECT_LT(serial_.size(), 16u);
  board().schedule_edge(2, true, now_ + 100);
  run(20 * kMillisecond);
  EXPECT_EQ(serial_, "before and after");
}

TEST_F(PowerTest, ADividedClockMakesEverythingSlowerUntilAReset) {
  start(R"(#include <avr/wdt.h>
void pressed() { digitalWrite(12, HIGH); }
void setup() {
  pinMode(12, OUTPUT);
  pinMode(13, OUTPUT);
  attachInterrupt(0, pressed, RISING);
  digitalWrite(13, HIGH);
  delay(10);
  digitalWrite(13, LOW);
  CLKPR = _BV(CLKPCE);
  CLKPR = _BV(CLKPS1) | _BV(CLKPS0);
  digitalWrite(13, HIGH);
  delay(10);
  digitalWrite(13, LOW);
  wdt_enable(WDTO_15MS);
}
void loop() {})");
  board().schedule_edge(2, true, 50 * kMillisecond);
  run(130 * kMillisecond);
  const std::vector<SimTime> pressed = changes(12), levels = changes(13);
  ASSERT_GE(pressed.size(), 2u);
  EXPECT_NEAR(static_cast<double>(pressed[1]), 50e6, 0.1e6);
  ASSERT_GE(levels.size(), 7u);
  const auto length = [&](std::size_t i) { return static_cast<double>(levels[i + 1] - levels[i]); };
  EXPECT_NEAR(length(1), 10e6, 0.1e6);
  EXPECT_NEAR(length(3), 80e6, 0.5e6);
  EXPECT_NEAR(length(levels.size() - 3), 10e6, 0.1e6) << "after the watchdog's reset";
  EXPECT_EQ(avr_->watchdog_resets(), 1);
}

TEST_F(PowerTest, SleepWithInterruptsOffIsTheEnd) {
  start("#include <avr/sleep.h>\nvoid setup() { cli(); sleep_enable(); sleep_cpu(); }\nvoid loop() {}");
  run(10 * kMillisecond);
  EXPECT_FALSE(avr_->crash());
  EXPECT_EQ(avr_->activity().stopped_by, "sleeping with interrupts off");
  EXPECT_LT(avr_->last_call(), 2 * kMillisecond);
}

}  // namespace robosim::exec::power_test
