// Tests the registers, flags and interrupts of timers on the host.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::timers_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;
using testing::SizeIs;

using TimersTest = HostTest;

TEST_F(TimersTest, ACompareMatchInterruptsAtItsFrequency) {
  // With prescaler 64 and 250 counts, the frequency is 16 MHz / 64 / 250 = 1 kHz.
  output(R"(volatile long count;
ISR(TIMER1_COMPA_vect) { ++count; }
void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS11) | _BV(CS10);
  OCR1A = 249;
  TIMSK1 = _BV(OCIE1A);
  count = 0;
  delay(500);
  Serial.println(count);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(500));
}

TEST_F(TimersTest, HandlersRunAtEvenDistancesWhateverTheSketchDoes) {
  start(R"(ISR(TIMER2_OVF_vect) { PINB = _BV(5); }
void setup() { DDRB = _BV(5); TCCR2A = 0; TCCR2B = 7; TIMSK2 = _BV(TOIE2); }
void loop() { for (volatile int i = 0; i < 100; ++i); delay(3); analogRead(0); })");
  run(500 * kMillisecond);
  const std::vector<SimTime> times = changes(13);
  ASSERT_GT(times.size(), 20u);
  // Timer 2 overflows every 256 * 1024 cycles. The first interrupt comes early, because the PWM of init() has
  // already set the overflow flag.
  for (std::size_t i = 3; i < times.size(); ++i)
    EXPECT_NEAR(static_cast<double>(times[i] - times[i - 1]), 16.384e6, 15e3);
}

TEST_F(TimersTest, CountersCanBeReadAndSet) {
  output(R"(void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  TCNT1 = 1000;
  delayMicroseconds(500);
  const unsigned int count = TCNT1;
  Serial.println(count);
}
void loop() {})");
  ASSERT_THAT(numbers(), SizeIs(1));
  EXPECT_NEAR(static_cast<double>(numbers()[0]), 2000, 10);
}

TEST_F(TimersTest, FlagsCanBePolled) {
  output(R"(void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS11) | _BV(CS10);
  OCR1A = 24999;
  TCNT1 = 0;
  TIFR1 = _BV(OCF1A);
  const unsigned long start = micros();
  while (!(TIFR1 & _BV(OCF1A)));
  Serial.println(micros() - start);
  TIFR1 = _BV(OCF1A);
  Serial.println((TIFR1 & _BV(OCF1A)) != 0);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(AllOf(Ge(99990), Le(100020)), 0));
}

// The expected TIFR1 is the value on target avr. Bit TOV1 depends on the prescaler's phase, which starts at
// reset.
TEST_F(TimersTest, InitsPwmHasRaisedFlagsThatStayInAnotherMode) {
  output(R"(volatile int count;
ISR(TIMER1_COMPA_vect) { ++count; }
ISR(TIMER2_OVF_vect) { count += 10; TIMSK2 = 0; }
void setup() {
  Serial.begin(115200);
  TCCR1A = TCCR1B = 0;
  TCNT1 = 0;
  OCR1A = 15624;
  OCR1B = 15000;
  TCCR1B |= _BV(WGM12) | _BV(CS12) | _BV(CS10);
  TIMSK1 |= _BV(OCIE1A);
  delayMicroseconds(100);
  Serial.println(count);
  Serial.println(TIFR1);
  TIFR1 = _BV(OCF1B);
  Serial.println(TIFR1);
  TCCR2A = TCNT2 = 0;
  TCCR2B = 7;
  Serial.println(TIFR2);
  TIMSK2 = _BV(TOIE2);
  delayMicroseconds(100);
  Serial.println(count);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(1, 4, 0, 7, 11));
}

TEST_F(TimersTest, WithAMainOfItsOwnASketchFindsTimersAsAResetLeavesThem) {
  output(R"(int main() {
  TCNT1 = 0xC2F7;
  const uint16_t count = TCNT1;
  const uint8_t flags = TIFR1;
  sei();
  Serial.begin(115200);
  Serial.println(count);
  Serial.println(flags);
  for (;;);
})");
  EXPECT_THAT(numbers(), ElementsAre(0xC2F7, 0));
}

TEST_F(TimersTest, AnotherPrescalerOfTimer0ChangesMillisWithIt) {
  start(
      "void setup() { TCCR0B = (TCCR0B & 0xF8) | 2; pinMode(13, OUTPUT); delay(800); digitalWrite(13, HIGH); "
      "} void loop() {}");
  run(200 * kMillisecond);
  ASSERT_EQ(changes(13).size(), 2u);
  EXPECT_NEAR(static_cast<double>(changes(13)[1]), 100e6, 0.2e6);  // delay(800) is eight times faster
}

TEST_F(TimersTest, DelayStaysExactWithAHandlerOnTimer0) {
  output(R"(volatile int count;
ISR(TIMER0_COMPA_vect) { ++count; }
void setup() {
  Serial.begin(115200);
  OCR0A = 0xAF;
  TIMSK0 |= _BV(OCIE0A);
  const unsigned long start = millis();
  delay(1024);
  Serial.println(millis() - start);
  Serial.println(count);
}
void loop() {})",
         2 * kSecond);
  EXPECT_THAT(numbers(), ElementsAre(1024, AllOf(Ge(999), Le(1001))));
}

}  // namespace robosim::exec::timers_test
