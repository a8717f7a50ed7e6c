// Tests power cycles, the EEPROM, sleep and the clock.
#include "tests/support/clock_sketch.h"
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::power_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;

TEST_P(OnEveryTarget, EveryPowerCycleBeginsWithFreshVariables) {
  start(R"(int count; int preset = 5; String text = "a";
void setup() { Serial.begin(115200); ++count; ++preset; text += "b"; static int inner = 3; ++inner; Serial.print(count); Serial.print(preset); Serial.print(inner); Serial.println(text); }
void loop() {})");
  run(20 * kMillisecond);
  executor_->power_off(now_);
  run(20 * kMillisecond);
  executor_->power_on(now_);
  run(20 * kMillisecond);
  EXPECT_EQ(serial_, "164ab\r\n164ab\r\n");
}

TEST_P(OnEveryTarget, TheEepromSurvivesAPowerCycle) {
  start(R"(#include <EEPROM.h>
void setup() { Serial.begin(115200); Serial.println(EEPROM.read(3)); EEPROM.write(3, EEPROM.read(3) - 100); }
void loop() {})");
  for (int cycle = 0; cycle < 2; ++cycle) {
    executor_->power_on(now_);
    run(100 * kMillisecond);
  }
  EXPECT_THAT(numbers(), ElementsAre(255, 155));
  // The Blue Pill's Arduino core keeps the EEPROM's bytes in flash, which the board does not see.
  if (executor_->has_boards_eeprom()) {
    EXPECT_EQ(executor_->probe().memory()[3], 55);
  }
}

TEST_P(OnEveryTarget, SwitchedOffAllPinsAreInputsAndNothingRuns) {
  start("void setup() { pinMode(13, OUTPUT); } void loop() { digitalWrite(13, !digitalRead(13)); }");
  run(5 * kMillisecond);
  EXPECT_EQ(drive("13").mode, PinMode::output);
  executor_->power_off(now_);
  EXPECT_EQ(drive("13"), PinDrive{});
  const std::size_t before = pins_.size();
  run(10 * kMillisecond);
  EXPECT_EQ(pins_.size(), before);
}

TEST_P(OnAtmega, AnEepromWriteTakes3400Microseconds) {
  output(R"(#include <EEPROM.h>
void setup() {
  Serial.begin(115200);
  const unsigned long start = micros();
  for (int i = 0; i < 10; ++i) EEPROM.write(i, i);
  Serial.println(micros() - start);
}
void loop() {})",
         100 * kMillisecond);
  ASSERT_EQ(numbers().size(), 1u);
  EXPECT_NEAR(static_cast<double>(numbers()[0]), 9 * 3400, 200) << "the tenth byte is still being written";
}

TEST_P(OnAtmega, TheEepromIsTheBoardsAlsoWhileTheSketchRuns) {
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
  executor_->probe().memory()[9] = 42;
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(7, 42));
}

TEST_P(OnEveryTarget, AFastClockShowsInEverythingTheSketchTimes) {
  start(
      R"(void setup() { Serial.begin(115200); pinMode(13, OUTPUT); digitalWrite(13, HIGH); delay(1000); digitalWrite(13, LOW); }
void loop() { digitalWrite(13, !digitalRead(13)); delay(100); })");
  executor_->set_clock_drift(100'000, 0);
  run(kSecond);
  const std::vector<SimTime> fast = changes(pin("13"));
  ASSERT_GE(fast.size(), 3u);
  EXPECT_NEAR(static_cast<double>(fast[2] - fast[1]), 1e9 / 1.1, 2e6);
  executor_->set_clock_drift(0, now_);
  const SimTime right = now_;
  run(kSecond);
  const std::vector<SimTime> all = changes(pin("13"));
  EXPECT_NEAR(static_cast<double>(all[all.size() - 1] - all[all.size() - 2]), 1e8, 2e6);
  EXPECT_GT(all.back(), right);
  EXPECT_LE(executor_->last_call(), now_);
  EXPECT_GT(executor_->last_call(), now_ - 2 * kMillisecond);
}

TEST_P(OnEveryTarget, TwoRunsAreTheSameToTheNanosecond) {
  const std::string text = R"(void setup() { Serial.begin(57600); pinMode(9, OUTPUT); }
void loop() {
  for (int i = 0; i < random(9); ++i) analogWrite(9, analogRead(A0) / 4 + millis() % 7 + i);
  Serial.println(micros());
})";
  std::vector<SimTime> first;
  for (const bool is_new : {true, true, false}) {  // the third run is a power cycle of the second
    if (is_new) start(text);
    if (!is_new) executor_->power_off(now_);
    const SimTime begin = now_;
    byte_times_.clear();
    pins_.clear();
    if (!is_new) executor_->power_on(begin);
    run(300 * kMillisecond);
    std::vector<SimTime> times = changes(pin("9"));
    times.insert(times.end(), byte_times_.begin(), byte_times_.end());
    for (SimTime& time : times) time -= begin;
    if (first.empty()) first = times;
    EXPECT_EQ(times, first);
  }
  EXPECT_GT(first.size(), 100u);
}

TEST_P(OnEveryTarget, ASketchMayHaveItsOwnMain) {
  EXPECT_EQ(
      output("int main() { init(); Serial.begin(115200); delay(5); Serial.print(millis() > 3); for (;;) {} }",
             20 * kMillisecond),
      "1");
}

TEST_P(OnEveryTarget, AHangIsNoCrashAndItsPlaceIsKnown) {
  start(
      "volatile bool flag;\n__attribute__((noinline)) void wait() {\n  while (!flag) {\n  }\n}\nvoid setup() "
      "{ delay(20); wait(); }\n"
      "void loop() {}\n");
  run(kSecond);
  EXPECT_FALSE(executor_->crash());
  const Activity activity = executor_->activity();
  EXPECT_LT(activity.last_call, 25 * kMillisecond) << "the clock goes on interrupting";
  EXPECT_EQ(activity.where.function, "wait");
  EXPECT_EQ(activity.where.file, "Test.ino");
  EXPECT_EQ(activity.where.line, 3);
  start("void setup() { delay(5); while (millis() < 100000) {} }\nvoid loop() {}");
  run(500 * kMillisecond);
  EXPECT_GT(executor_->last_call(), 499 * kMillisecond) << "a loop that calls millis() does not hang";
}

class ClockStart : public TargetTest {
 protected:
  void before_power_on() override { executor_->chip_access()->set_clock_start(4294967 * kSecond); }
};
INSTANTIATE_TEST_SUITE_P(, ClockStart, testing::ValuesIn(targets({"avr", "stm32"})), name_of);

TEST_P(ClockStart, MayBeShortlyBeforeMillisWraps) {
  start(
      R"(void setup() { Serial.begin(115200); Serial.println(millis()); delay(1000); Serial.println(millis()); }
void loop() {})");
  for (int cycle = 0; cycle < 2; ++cycle) {
    if (cycle > 0) executor_->power_on(now_);
    serial_.clear();
    run(1500 * kMillisecond);
    ASSERT_EQ(numbers().size(), 2u);
    EXPECT_NEAR(static_cast<double>(numbers()[0]), 4294967000.0, 1.0);
    EXPECT_NEAR(static_cast<double>(numbers()[1]), 704.0, 2.0);
  }
}

TEST_P(OnAtmega, IdleSleepEndsWithTheNextInterrupt) {
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
  EXPECT_THAT(numbers(), ElementsAre(AllOf(Ge(99), Le(102)))) << "timer 0 wakes the chip every 1.024 ms";
  EXPECT_EQ(executor_->last_call(), now_) << "sleep is not a hang";
  EXPECT_EQ(executor_->activity().stopped_by, "");
  if (ChipAccess* const chip = executor_->chip_access()) {
    EXPECT_LT(chip->resources().value().cpu_load, 0.02);
  }
}

// Both versions of the Pro Mini differ only in clock and supply voltage, which are data of the board.
TEST_P(OnAtmega, AProMiniKeepsTimeAtItsClockAndMeasuresByItsSupply) {
  const auto run_sketch_on = [&](const test::ClockedBoard& clocked) {
    board_name_ = clocked.name;
    start(test::kClockSketch);
    FixedSource half(clocked.supply_volts / 2);
    board().connect(pin("A7"), half);
    run(kSecond);
    const test::ReadTimes times = test::expect_clock(clocked, numbers(), changes(pin("12")));
    EXPECT_NEAR(times.ten_analog_us, test::kTenReads_us, 10);
    return times;
  };
  const test::ReadTimes at_8 = run_sketch_on(test::kProMinis[0]);
  test::expect_twice_the_time(at_8, run_sketch_on(test::kProMinis[1]));
}

}  // namespace robosim::exec::power_test
