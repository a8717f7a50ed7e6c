// Tests that the host executor's watchdog behaves like the ATmega328P's.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::watchdog_test {

using testing::ElementsAre;
using testing::HasSubstr;

class WatchdogTest : public HostTest {};

TEST_F(WatchdogTest, StartsASketchAgainThatHangs) {
  start(R"(#include <avr/wdt.h>
#include <EEPROM.h>
int kept = 5;
void setup() {
  Serial.begin(115200);
  EEPROM.write(0, EEPROM.read(0) + 1);
  Serial.println(EEPROM.read(0));
  Serial.println(kept++);
  wdt_enable(WDTO_120MS);
}
void loop() { if (EEPROM.read(0) == 0) for (;;); else wdt_reset(); })");
  run(100 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 5));
  EXPECT_FALSE(host_->hangs());
  run(900 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 5, 1, 5));
  EXPECT_FALSE(host_->crash());
  EXPECT_EQ(host_->watchdog_resets(), 1);
  host_->power_off(kSecond);
  host_->power_on(kSecond);
  EXPECT_EQ(host_->watchdog_resets(), 1) << "the count includes resets before the power was off";
}

TEST_F(WatchdogTest, BitesWithInterruptsOffAndWhereASketchHasGivenUp) {
  for (const char* end : {"noInterrupts(); for (;;);", "exit(0);", "delay(2000);"}) {
    SCOPED_TRACE(end);
    serial_.clear();
    start(std::string(
              "#include <avr/wdt.h>\nvoid setup() { Serial.begin(115200); Serial.println(1); Serial.flush(); "
              "wdt_enable(WDTO_500MS); ") +
          end + " }\nvoid loop() { wdt_reset(); }\n");
    run(800 * kMillisecond);
    EXPECT_THAT(numbers(), ElementsAre(1, 1));
  }
}

TEST_F(WatchdogTest, ThatBitesAgainAndAgainIsACrashWhereItBit) {
  start("#include <avr/wdt.h>\nvoid setup() {\n  wdt_enable(WDTO_1S);\n  for (;;);\n}\nvoid loop() {}\n");
  run(2900 * kMillisecond);
  EXPECT_FALSE(host_->crash());
  run(200 * kMillisecond);
  ASSERT_TRUE(host_->crash());
  EXPECT_THAT(host_->crash()->reason, HasSubstr("the watchdog has reset the chip 3 times"));
  EXPECT_EQ(host_->crash()->where.line, 4);
}

TEST_F(WatchdogTest, InterruptsAndWakesASleepingSketch) {
  start(R"(#include <avr/wdt.h>
#include <avr/sleep.h>
volatile int naps;
ISR(WDT_vect) { ++naps; }
void setup() {
  Serial.begin(115200);
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE) | _BV(WDP2) | _BV(WDP0);
  set_sleep_mode(SLEEP_MODE_PWR_DOWN);
}
void loop() { sleep_mode(); Serial.println(naps); Serial.flush(); if (naps == 3) wdt_disable(); })");
  run(3000 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 2, 3));
}

TEST_F(WatchdogTest, WithBothBitsInterruptsFirstAndThenResets) {
  start(R"(#include <avr/wdt.h>
ISR(WDT_vect) { Serial.println(2); }
void setup() {
  Serial.begin(115200);
  Serial.println(1);
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE) | _BV(WDE) | _BV(WDP2);
}
void loop() {})");
  run(700 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 2, 1));
}

TEST_F(WatchdogTest, IsNotStoppedWithoutItsUnlocking) {
  start(R"(#include <avr/wdt.h>
void setup() { Serial.begin(115200); Serial.println(1); wdt_enable(WDTO_250MS); delay(1); WDTCSR = 0; Serial.println(WDTCSR); }
void loop() {})");
  run(400 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 12, 1, 12));
}

}  // namespace robosim::exec::watchdog_test
