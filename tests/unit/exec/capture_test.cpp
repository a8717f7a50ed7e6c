// Tests that timer 1 captures the times of edges at pin 8. The expected values are those of the ATmega328P.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::capture_test {

using testing::ElementsAre;

class Capture : public HostTest {};

TEST_F(Capture, EdgesOfARobotAreTimedAsTheyCome) {
  start(R"(volatile unsigned int rise, high, low, served;
ISR(TIMER1_CAPT_vect) {
  const unsigned int at = ICR1;
  if (TCCR1B & _BV(ICES1)) low = at - rise - high; else high = at - rise;
  if (TCCR1B & _BV(ICES1)) rise = at;
  TCCR1B ^= _BV(ICES1);
  TIFR1 = _BV(ICF1);
  ++served;
}
void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(ICES1) | _BV(CS11);
  TIFR1 = _BV(ICF1);
  TIMSK1 = _BV(ICIE1);
}
void loop() {
  delay(5);
  if (served < 7) return;
  Serial.println(served);
  Serial.println(high);
  Serial.println(low);
  TIMSK1 = served = 0;
})");
  run(10 * kMillisecond);
  // The pin is high for 1 ms, then low for 2 ms. These are 2000 and 4000 timer ticks of half a microsecond.
  for (int i = 0; i < 7; ++i)
    board().schedule_edge(8, i % 2 == 0, now_ + (i / 2 * 3 + i % 2) * kMillisecond + 300 * kMicrosecond);
  run(40 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(7, 2000, 4000));
}

TEST_F(Capture, OwnEdgesAreCapturedAndTheFlagCanBePolled) {
  EXPECT_THAT(printed(R"(
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  pinMode(8, OUTPUT);
  TIFR1 = _BV(ICF1);
  digitalWrite(8, HIGH);
  Serial.println(TIFR1 & _BV(ICF1));  // timer 1 captures falling edges
  TCNT1 = 1000;
  digitalWrite(8, LOW);
  Serial.println(TIFR1 & _BV(ICF1));
  Serial.println(ICR1 / 100);
  TIFR1 = _BV(ICF1);
  Serial.println(TIFR1 & _BV(ICF1));
  tone(8, 500);
  unsigned int at[2];
  for (int i = 0; i < 2; ++i) {
    TIFR1 = _BV(ICF1);
    while (!(TIFR1 & _BV(ICF1)));
    at[i] = ICR1;
  }
  Serial.println((uint16_t)(at[1] - at[0]));)"),
              ElementsAre(0, 32, 10, 0, 4000));
}

TEST_F(Capture, TheNoiseCancelerPassesNoPulseOfLessThanFourCycles) {
  start(R"(void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(ICNC1) | _BV(ICES1) | _BV(CS11);
  TIFR1 = _BV(ICF1);
}
void loop() {
  delay(5);
  Serial.println(TIFR1 & _BV(ICF1));
  TIFR1 = _BV(ICF1);
})");
  run(7 * kMillisecond);
  board().schedule_edge(8, true, now_);
  board().schedule_edge(8, false, now_ + 200);
  run(5 * kMillisecond);
  board().schedule_edge(8, true, now_);
  board().schedule_edge(8, false, now_ + 300);
  run(5 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 0, 32));
}

TEST_F(Capture, Icr1IsWrittenOnlyAsTopWhereItRaisesItsFlag) {
  output(R"(volatile int tops;
ISR(TIMER1_CAPT_vect) { ++tops; }
void setup() {
  Serial.begin(115200);
  TCCR1A = TCCR1B = 0;
  ICR1 = 4711;
  Serial.println(ICR1);
  TCCR1B = _BV(WGM13) | _BV(WGM12);
  ICR1 = 1999;
  Serial.println(ICR1);
  TCNT1 = 0;
  TIFR1 = 0xFF;
  TCCR1B |= _BV(CS11);
  TIMSK1 = _BV(ICIE1);
  delayMicroseconds(10500);
  TIMSK1 = 0;
  Serial.println(tops);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(0, 1999, 10));
}

}  // namespace robosim::exec::capture_test
