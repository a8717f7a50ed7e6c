// Tests power cycles, resets, sleep and the EEPROM of an emulated AVR.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace power_test {

using testing::ElementsAre;
using testing::HasSubstr;

class PowerTest : public AvrTest {};

TEST_F(PowerTest, EepromSurvivesAPowerCycleAndRamDoesNot) {
  start(R"(#include <EEPROM.h>
int ram;
void setup() {
  Serial.begin(115200);
  Serial.println(EEPROM.read(5) * 10 + ram);
  EEPROM.write(5, 7);
  ram = 3;
}
void loop() {})");
  run(20 * kMillisecond);
  EXPECT_EQ(avr_->probe().memory()[5], 7);
  avr_->power_off(now_);
  EXPECT_EQ(board().drive(1).mode, PinMode::input);
  run(10 * kMillisecond);
  avr_->power_on(now_);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(2550, 70));
}

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

TEST_F(PowerTest, AnEepromWriteTakes3400Microseconds) {
  output(R"(#include <EEPROM.h>
void setup() {
  Serial.begin(115200);
  unsigned long began = micros();
  EEPROM.write(1, 1); EEPROM.write(2, 2); EEPROM.write(3, 3);
  Serial.println((micros() - began) / 100);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(68)) << "the third byte is still being written";
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
  avr_->probe().memory()[9] = 42;
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(7, 42));
}

TEST_F(PowerTest, AFastClockShowsInEverythingTheSketchTimes) {
  start(
      R"(void setup() { Serial.begin(115200); pinMode(13, OUTPUT); digitalWrite(13, HIGH); delay(1000); digitalWrite(13, LOW); }
void loop() { digitalWrite(13, !digitalRead(13)); delay(100); })");
  avr_->set_clock_drift(100'000, 0);
  run(kSecond);
  const std::vector<SimTime> fast = changes(13);
  ASSERT_GE(fast.size(), 3u);
  EXPECT_NEAR(static_cast<double>(fast[2] - fast[1]), 1e9 / 1.1, 2e6);
  avr_->set_clock_drift(0, now_);
  const SimTime right = now_;
  run(kSecond);
  const std::vector<SimTime> all = changes(13);
  EXPECT_NEAR(static_cast<double>(all[all.size() - 1] - all[all.size() - 2]), 1e8, 2e6);
  EXPECT_GT(all.back(), right);
  EXPECT_LE(avr_->last_call(), now_);
  EXPECT_GT(avr_->last_call(), now_ - 2 * kMillisecond);
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

TEST_F(PowerTest, IdleSleepEndsWithTheNextInterrupt) {
  start(R"(#include <avr/sleep.h>
unsigned wakes;
void setup() {
  Serial.begin(115200);
  set_sleep_mode(SLEEP_MODE_IDLE);
  while (millis() < 103) { sleep_mode(); ++wakes; }
  Serial.println(wakes);
}
void loop() { sleep_mode(); })");
  run(kSecond);
  EXPECT_THAT(numbers(), ElementsAre(testing::AllOf(testing::Ge(99), testing::Le(102))))
      << "timer 0 wakes the chip every 1.024 ms";
  const auto used = avr_->resources();
  ASSERT_TRUE(used);
  EXPECT_LT(used->cpu_load, 0.02);
  EXPECT_EQ(avr_->last_call(), now_) << "sleep is not a hang";
  EXPECT_EQ(avr_->activity().stopped_by, "");
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
  CLKPR = 0x80;
  CLKPR = 3;
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

TEST_F(PowerTest, TwoRunsAreTheSameToTheNanosecond) {
  const std::string text = R"(void setup() { Serial.begin(57600); pinMode(9, OUTPUT); }
void loop() { int v = analogRead(A0); analogWrite(9, v / 4 + millis() % 7); Serial.println(v); })";
  std::vector<SimTime> first;
  for (int i = 0; i < 2; ++i) {
    start(text);
    run(300 * kMillisecond);
    std::vector<SimTime> times = changes(9);
    times.insert(times.end(), byte_times_.begin(), byte_times_.end());
    if (i == 0) first = times;
    EXPECT_EQ(times, first);
  }
  EXPECT_GT(first.size(), 100u);
}

TEST_F(PowerTest, AHangIsSilentWhileTimer0GoesOnInterrupting) {
  start("volatile bool flag;\nvoid setup() { delay(5); while (!flag) {} }\nvoid loop() {}");
  run(500 * kMillisecond);
  EXPECT_LT(avr_->last_call(), 7 * kMillisecond);
  start("void setup() { delay(5); while (millis() < 100000) {} }\nvoid loop() {}");
  run(500 * kMillisecond);
  EXPECT_GT(avr_->last_call(), 499 * kMillisecond) << "a loop that calls millis() does not hang";
}

}  // namespace power_test
}  // namespace robosim::exec
