// Tests the decision whether a sketch without output hangs, or waits for an interrupt that may still come.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::hang_test {

constexpr SimTime kLong = 2100 * kMillisecond;
const char* const kTimer2 = "TCCR2B = _BV(CS22) | _BV(CS21) | _BV(CS20); TIMSK2 = _BV(TOIE2);";
const char* const kFreeAdc =
    "ADMUX = _BV(REFS0) | _BV(ADLAR); ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE) | _BV(ADIE) | 7;";

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
  EXPECT_FALSE(hangs("ISR(TIMER2_OVF_vect) { other++; }", kTimer2));
  EXPECT_FALSE(hangs("ISR(WDT_vect) { other++; }", "WDTCSR = _BV(WDCE) | _BV(WDE); WDTCSR = _BV(WDIE) | 7;"));
  EXPECT_FALSE(hangs("ISR(ADC_vect) { other++; }", kFreeAdc));
  EXPECT_FALSE(
      hangs("ISR(PCINT0_vect) { other++; }", "DDRB = _BV(0); PCICR = _BV(PCIE0); PCMSK0 = _BV(PCINT0);"));
}

TEST_F(HangTest, AWaitForWhatAHandlerMayWriteIsNone) {
  EXPECT_FALSE(hangs("ISR(TIMER2_OVF_vect) { if (count++ > 100000) go = 1; }", kTimer2));
  EXPECT_FALSE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING);"));
  EXPECT_FALSE(hangs("ISR(PCINT1_vect) { go = 1; }", "PCICR = _BV(PCIE1); PCMSK1 = _BV(PCINT8);"));
  EXPECT_FALSE(hangs("ISR(ADC_vect) { go = ADCH; }", kFreeAdc));
  EXPECT_FALSE(hangs("ISR(WDT_vect) { go = 1; }",
                     "WDTCSR = _BV(WDCE) | _BV(WDE); WDTCSR = _BV(WDIE) | _BV(WDP3) | 7;"));
  EXPECT_FALSE(hangs("ISR(ANALOG_COMP_vect) { go = 1; }", "ACSR = _BV(ACIE);"));
  EXPECT_FALSE(hangs("", "", "Serial.available()")) << "a byte may come";
}

TEST_F(HangTest, AHandlerThatDoesSomethingByItselfIsLife) {
  EXPECT_FALSE(hangs("ISR(TIMER1_COMPA_vect) { PORTB ^= _BV(5); }",
                     "TCCR1B = _BV(WGM12) | _BV(CS11) | _BV(CS10); OCR1A = 60000; TIMSK1 = _BV(OCIE1A);"));
}

TEST_F(HangTest, WhatIsEnabledAndCannotComeIsNone) {
  EXPECT_TRUE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING); noInterrupts();"));
  EXPECT_TRUE(hangs("void set() { go = 1; }", "attachInterrupt(0, set, FALLING); detachInterrupt(0);"));
  EXPECT_TRUE(hangs("ISR(PCINT1_vect) { go = 1; }", "PCICR = _BV(PCIE1);"))
      << "no pin is enabled in the mask";
  EXPECT_TRUE(hangs("ISR(ADC_vect) { go = ADCH; }", "ADCSRA = _BV(ADEN) | _BV(ADIE) | 7;"))
      << "nothing is converted";
}

TEST_F(HangTest, AResetByTheWatchdogMayCome) { EXPECT_FALSE(hangs("", "wdt_enable(WDTO_8S);")); }

TEST_F(HangTest, AComputationThatTakesLongIsNone) {
  EXPECT_FALSE(hangs("", "for (count = 0; count < 10000000; count++);"));
}

TEST_F(HangTest, SleepWithInterruptsOffIsAHang) {
  EXPECT_TRUE(hangs("#include <avr/sleep.h>", "noInterrupts(); sleep_enable(); sleep_cpu();"));
}

}  // namespace robosim::exec::hang_test
