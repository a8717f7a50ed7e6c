// Tests the emulated AVR's ADC with sketches that run on a board.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::analog_test {

class AnalogTest : public AvrTest {};

TEST_F(AnalogTest, AConversionIsSampledOneAndAHalfClocksAfterItsStartAndTakesThirteen) {
  start(R"(void setup() {
  pinMode(13, OUTPUT);
  analogRead(A0);
  PORTB |= _BV(5); ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {}
  PORTB &= ~_BV(5);
}
void loop() {})");
  FixedSource source(1.0);
  board().connect(14, source);
  run(5 * kMillisecond);
  ASSERT_EQ(source.asked_at.size(), 2u);
  const SimTime started = changes(13)[1], ended = changes(13)[2];
  // The conversion starts with the next ADC clock. The clock period is 8 us.
  const auto sampled = static_cast<double>(source.asked_at[1]);
  EXPECT_NEAR(sampled - static_cast<double>(started), 16e3, 4.5e3);
  EXPECT_NEAR(static_cast<double>(ended) - sampled, 104e3 - 12e3, 1e3);
}

TEST_F(AnalogTest, FreeRunningSamplesEvery104Microseconds) {
  start(
      "void setup() { ADMUX = _BV(REFS0); ADCSRB = 0; ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE) | 7; "
      "}\nvoid loop() {}");
  FixedSource source(2.0);
  board().connect(14, source);
  run(10 * kMillisecond);
  ASSERT_GT(source.asked_at.size(), 80u);
  EXPECT_NEAR(static_cast<double>(source.asked_at[50] - source.asked_at[10]) / 40, 104e3, 200.0);
}

TEST_F(AnalogTest, TheBandgapReadingDependsOnTheSupply) {
  EXPECT_EQ(
      output("void setup() { Serial.begin(115200); ADMUX = _BV(REFS0) | 14; delay(2); ADCSRA |= _BV(ADSC); "
             "while (ADCSRA & _BV(ADSC)) {} Serial.println(ADC); }\nvoid loop() {}"),
      "225\r\n");
}

}  // namespace robosim::exec::analog_test
