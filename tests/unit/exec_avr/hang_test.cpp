// Tests the decision whether a sketch without output hangs, or waits for an interrupt that may still come.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace hang_test {

constexpr SimTime kLong = 2100 * kMillisecond;

class HangTest : public AvrTest {
 protected:
  /// Runs a sketch whose setup() executes `before` and then waits for `awaited`. Returns whether the sketch
  /// hangs.
  bool hangs(const std::string& handlers, const std::string& before, const std::string& awaited = "go") {
    start("#include <avr/wdt.h>\nvolatile byte go, other; volatile long count;\n" + handlers +
          "\nvoid setup() { Serial.begin(9600); " + before + " while (!(" + awaited +
          ")); }\nvoid loop() {}");
    for (const SimTime end = now_ + kLong; now_ < end;) {
      avr_->run_until(now_ += kTick);
      avr_->hangs();
    }
    EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
    return avr_->hangs();
  }
};

TEST_F(HangTest, AWaitForWhatNoHandlerWritesIsAHang) { EXPECT_TRUE(hangs("", "")); }

TEST_F(HangTest, AnyHandlerOfTheSketchsOwnIsLifeAsOnTheHost) {
  EXPECT_FALSE(hangs("ISR(TIMER2_OVF_vect) { other++; }", "TCCR2B = 7; TIMSK2 = 1;"));
  EXPECT_FALSE(hangs("ISR(WDT_vect) { other++; }", "WDTCSR = 0x18; WDTCSR = 0x47;"));
  EXPECT_FALSE(hangs("ISR(ADC_vect) { other++; }", "ADMUX = 0x60; ADCSRA = 0xEF;"));
  EXPECT_FALSE(hangs("ISR(PCINT0_vect) { other++; }", "DDRB = 1; PCICR = 1; PCMSK0 = 1;"));
}

TEST_F(HangTest, AWaitForWhatAHandlerMayWriteIsNone) {
  EXPECT_FALSE(hangs("ISR(TIMER2_OVF_vect) { if (count++ > 100000) go = 1; }", "TCCR2B = 7; TIMSK2 = 1;"));
  EXPECT_FALSE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING);"));
  EXPECT_FALSE(hangs("ISR(PCINT1_vect) { go = 1; }", "PCICR = 2; PCMSK1 = 1;"));
  EXPECT_FALSE(hangs("ISR(ADC_vect) { go = ADCH; }", "ADMUX = 0x60; ADCSRA = 0xEF;"));
  EXPECT_FALSE(hangs("ISR(WDT_vect) { go = 1; }", "WDTCSR = 0x18; WDTCSR = 0x47 | 0x20;"));
  EXPECT_FALSE(hangs("ISR(ANALOG_COMP_vect) { go = 1; }", "ACSR = 0x08;"));
  EXPECT_FALSE(hangs("", "", "Serial.available()")) << "a byte may come";
}

TEST_F(HangTest, AHandlerThatDoesSomethingByItselfIsLife) {
  EXPECT_FALSE(hangs("ISR(TIMER1_COMPA_vect) { PORTB ^= 32; }", "TCCR1B = 0x0B; OCR1A = 60000; TIMSK1 = 2;"));
}

TEST_F(HangTest, WhatIsEnabledAndCannotComeIsNone) {
  EXPECT_TRUE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING); noInterrupts();"));
  EXPECT_TRUE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING); detachInterrupt(0);"));
  EXPECT_TRUE(hangs("ISR(PCINT1_vect) { go = 1; }", "PCICR = 2;")) << "no pin is enabled in the mask";
  EXPECT_TRUE(hangs("ISR(ADC_vect) { go = ADCH; }", "ADCSRA = 0x8F;")) << "nothing is converted";
}

TEST_F(HangTest, AResetByTheWatchdogMayCome) { EXPECT_FALSE(hangs("", "wdt_enable(WDTO_8S);")); }

TEST_F(HangTest, AComputationThatTakesLongIsNone) {
  EXPECT_FALSE(hangs("", "for (count = 0; count < 10000000; count++);"));
}

TEST_F(HangTest, SleepWithInterruptsOffIsAHang) {
  EXPECT_TRUE(hangs("#include <avr/sleep.h>", "noInterrupts(); sleep_enable(); sleep_cpu();"));
}

}  // namespace hang_test
}  // namespace robosim::exec
