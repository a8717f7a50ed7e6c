// Tests reads and interrupts of pins that the sketch drives itself. The expected values are those of the
// ATmega328P.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::own_outputs_test {

using testing::ElementsAre;

class OwnOutputs : public HostTest {};

TEST_F(OwnOutputs, PwmAndTonesAreReadAsTheyAreAtTheMoment) {
  output(R"(bool is_high(uint8_t pin) { return (pin < 8 ? PIND >> pin : PINB >> (pin - 8)) & 1; }
// Returns the duration of a high level, in units of 64 us.
int high(uint8_t pin) {
  while (is_high(pin));
  while (!is_high(pin));
  const unsigned long from = micros();
  while (is_high(pin));
  return (micros() - from + 32) / 64;
}
void setup() {
  Serial.begin(115200);
  analogWrite(6, 63);  // fast PWM: 64 of 256 ticks of 4 us
  Serial.println(high(6));
  analogWrite(9, 64);  // phase correct: 2 * 64 ticks of 4 us
  Serial.println(high(9));
  TCCR1A |= _BV(COM1A0);  // inverted: high for the other 2 * 191 ticks
  Serial.println(high(9));
  TCCR1A = _BV(COM1A0);  // toggled after each 1536 ticks of half a microsecond
  TCCR1B = _BV(WGM12) | _BV(CS11);
  OCR1A = 1535;
  Serial.println(high(9));
  Serial.println((pulseIn(9, LOW) + 32) / 64);
  analogWrite(11, 0x80);
  Serial.println((pulseIn(11, HIGH) + 32) / 64);
  tone(4, 500);
  Serial.println((pulseIn(4, HIGH) + 32) / 64);
  int changes = 0, last = digitalRead(4);
  for (const unsigned long from = millis(); millis() - from < 100;) {
    const int level = digitalRead(4);
    changes += level != last;
    last = level;
  }
  Serial.println((changes + 2) / 5);
  noTone(4);
  Serial.println(pulseIn(4, HIGH, 5000));
  analogWrite(10, 200);
  Serial.println(digitalRead(10));  // the core takes the PWM off first
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(4, 8, 24, 12, 12, 16, 16, 20, 0, 0));
}

TEST_F(OwnOutputs, EdgesInterruptAsTheirSenseSays) {
  output(R"(volatile int rising, any, changes, low;
void on_rising() { ++rising; }
void on_any() { ++any; }
void on_low() { ++low; digitalWrite(2, HIGH); }
ISR(PCINT0_vect) { ++changes; }
void setup() {
  Serial.begin(115200);
  pinMode(2, OUTPUT);
  DDRD |= _BV(3);
  DDRB |= _BV(5);
  attachInterrupt(0, on_rising, RISING);
  attachInterrupt(1, on_any, CHANGE);
  PCICR = _BV(PCIE0);
  PCMSK0 = _BV(5);
  for (int i = 1; i <= 7; ++i) {
    digitalWrite(2, i & 1);
    PORTD ^= _BV(3);
    PINB = _BV(5);
    digitalWrite(12, i & 1);
    delayMicroseconds(20);
  }
  Serial.println(rising);
  Serial.println(any);
  Serial.println(changes);
  detachInterrupt(0);
  EIFR = 3;
  digitalWrite(2, LOW);
  Serial.println(EIFR);  // a falling edge does not set the flag
  digitalWrite(2, HIGH);
  Serial.println(EIFR);  // a rising edge sets the flag, even if the interrupt is disabled
  attachInterrupt(0, on_low, LOW);
  for (int i = 0; i < 5; ++i) {
    digitalWrite(2, LOW);
    delayMicroseconds(50);
  }
  Serial.println(low);
  changes = 0;  // from an output to an input with pull-up, and back
  pinMode(13, INPUT_PULLUP);
  delayMicroseconds(20);
  digitalWrite(13, LOW);
  pinMode(13, OUTPUT);
  delayMicroseconds(20);
  Serial.println(changes);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(4, 7, 7, 0, 1, 5, 1));
}

TEST_F(OwnOutputs, OneBitIsSetAloneWhereOnesAreWritten) {
  EXPECT_THAT(printed(R"(
  EICRA = 15;
  PORTD = _BV(2) | _BV(3);
  DDRD |= _BV(2) | _BV(3);
  Serial.println(EIFR);
  EIFR |= _BV(INTF0);  // SBI
  Serial.println(EIFR);
  DDRB = PORTB = _BV(5) | _BV(4) | _BV(3);
  PINB |= _BV(4);
  Serial.println(PORTB);
  volatile uint8_t mask = _BV(4);
  PINB |= mask;  // IN, OR, OUT: also toggles all pins that are high
  Serial.println(PORTB);)"),
              ElementsAre(3, 2, 0x28, 0x10));
}

TEST_F(OwnOutputs, EachPeriodOfPwmInterrupts) {
  output(R"(volatile unsigned edges, flags;
void edge() { ++edges; }
ISR(PCINT0_vect) { ++edges; }
unsigned in_100_ms() {
  noInterrupts();
  edges = 0;
  interrupts();
  delay(100);
  return (edges + 1) / 2;
}
void setup() {
  Serial.begin(115200);
  pinMode(3, OUTPUT);
  analogWrite(3, 100);
  attachInterrupt(1, edge, RISING);
  Serial.println(in_100_ms());  // 49
  // A new value holds from the next period on, so each period has the same number of edges.
  edges = 0;
  const unsigned long from = millis();
  for (int value = 1; millis() - from < 200; value = value % 254 + 1) {
    analogWrite(3, value);
    delayMicroseconds(130);
  }
  Serial.println((edges + 1) / 2);  // 98
  digitalWrite(3, LOW);
  Serial.println(in_100_ms());
  tone(12, 300);
  PCMSK0 = _BV(4);
  PCICR = _BV(PCIE0);
  Serial.println(in_100_ms());  // 60
  noTone(12);
  Serial.println(in_100_ms());
  analogWrite(3, 0x80);
  noInterrupts();
  for (int i = 0; i < 10; ++i) {
    EIFR = _BV(INTF1);
    while (!(EIFR & _BV(INTF1))) ++flags;
  }
  Serial.println(flags > 1000);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(25, 49, 0, 30, 0, 1));
}

// Timer 1 can count edges of pin 5, and timer 0 edges of pin 4.
TEST_F(OwnOutputs, ATimerCountsEdgesOfItsPin) {
  start(R"(volatile int full;
ISR(TIMER1_COMPA_vect) { ++full; }
void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = 7;
  analogWrite(5, 77);
  delay(500);
  Serial.println((TCNT1 + 2) / 5);  // 488
  digitalWrite(5, LOW);
  TCNT1 = 0;
  TCCR1B = 7 | _BV(WGM12);
  OCR1A = 9;
  TIMSK1 = _BV(OCIE1A);
  for (int i = 0; i < 25; ++i) {
    digitalWrite(5, HIGH);
    digitalWrite(5, LOW);
  }
  Serial.println(TCNT1);
  Serial.println(full);
  TCCR1B = 6;
  pinMode(5, INPUT);
  TCNT1 = 0;
  delay(50);
  Serial.println(TCNT1);
}
void loop() {})");
  run(510 * kMillisecond);
  for (int i = 0; i < 7; ++i) board().schedule_edge(5, i % 2 == 0, now_ + i * kMillisecond);
  run(60 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(98, 5, 3, 3));  // 3: two matches, and one from the PWM of init()
}

}  // namespace robosim::exec::own_outputs_test
