// Tests registers other than those of timers and pins. The expected values are those of the ATmega328P.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::registers_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class Registers : public HostTest {};

TEST_F(Registers, AdclLocksTheResultUntilAdchIsRead) {
  output(R"(void convert(uint8_t channel) {
  ADMUX = _BV(REFS0) | channel;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC));
}
void setup() {
  Serial.begin(115200);
  convert(14);  // the bandgap
  uint8_t low = ADCL, high = ADCH;
  Serial.println(high << 8 | low);
  convert(15);  // ground
  Serial.println(ADC);
  convert(14);
  low = ADCL;
  convert(15);
  high = ADCH;
  Serial.println(high << 8 | low);
  convert(15);
  Serial.println(ADC);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(225, 0, 225, 0));
}

TEST_F(Registers, DigitalInputsCanBeSwitchedOff) {
  EXPECT_THAT(printed(R"(
  pinMode(A5, INPUT_PULLUP);
  pinMode(7, OUTPUT);
  digitalWrite(7, HIGH);
  Serial.println(digitalRead(A5));
  DIDR0 = _BV(ADC5D);
  DIDR1 = _BV(AIN1D);
  Serial.println(digitalRead(A5));
  Serial.println(PINC & _BV(5));
  Serial.println(PIND & _BV(7));
  DIDR0 = DIDR1 = 0;
  Serial.println(PINC & _BV(5));
  Serial.println(PIND & _BV(7));)"),
              ElementsAre(1, 0, 0, 0, 32, 128));
}

TEST_F(Registers, TheEepromIsWrittenAndReadByItsRegisters) {
  output(R"(volatile uint8_t ready;
ISR(EE_READY_vect) { ++ready; EECR &= ~_BV(EERIE); }
uint8_t read() {
  while (EECR & _BV(EEPE));
  EECR |= _BV(EERE);
  return EEDR;
}
void setup() {
  Serial.begin(115200);
  const unsigned long from = micros();
  EEAR = 700;
  EEDR = 0xF0;
  EECR |= _BV(EEPE);
  Serial.println(read());  // EEMPE was not set before
  EEDR = 0xF0;
  EECR |= _BV(EEMPE);
  EECR |= _BV(EEPE);
  EECR |= _BV(EERIE);
  Serial.println(ready);
  while (EECR & _BV(EEPE));
  Serial.println((micros() - from) / 1000);
  Serial.println(ready);
  EEDR = 0x3C;
  EECR = _BV(EEPM1);
  EECR |= _BV(EEMPE);
  EECR |= _BV(EEPE);
  Serial.println(read());  // written without erasing
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(255, 0, 3, 1, 0x30));
  EXPECT_EQ(host_->probe().memory()[700], 0x30);
}

TEST_F(Registers, TheComparatorComparesInterruptsAndIsCaptured) {
  output(R"(volatile int compared, captured;
ISR(ANALOG_COMP_vect) { ++compared; }
ISR(TIMER1_CAPT_vect) { ++captured; }
void rise_and_fall(uint8_t pin) {
  for (int i = 1; i <= 10; ++i) {
    digitalWrite(pin, i & 1);
    delayMicroseconds(50);
  }
}
void setup() {
  Serial.begin(115200);
  for (uint8_t pin = 6; pin <= 8; ++pin) pinMode(pin, OUTPUT);
  digitalWrite(6, HIGH);
  Serial.println(ACSR & (_BV(ACO) | _BV(ACI)));
  digitalWrite(7, HIGH);
  ACSR = _BV(ACI);
  Serial.println(ACSR & (_BV(ACO) | _BV(ACI)));
  digitalWrite(7, LOW);
  ACSR = _BV(ACBG);
  Serial.println(ACSR & _BV(ACO));  // 1.1 V over 0 V
  ACSR = _BV(ACI) | _BV(ACIE) | _BV(ACIS1) | _BV(ACIS0) | _BV(ACIC);
  TCCR1A = 0;
  TCCR1B = _BV(ICES1) | _BV(CS11);
  digitalWrite(6, LOW);
  TIFR1 = _BV(ICF1);
  TIMSK1 = _BV(ICIE1);
  compared = captured = 0;
  rise_and_fall(6);
  rise_and_fall(8);  // captures nothing now
  Serial.println(compared);
  Serial.println(captured);
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(48, 0, 32, 5, 5));
}

TEST_F(Registers, TheReceiverHoldsThreeBytesAndTheSenderAsksUntilItIsAnswered) {
  start(R"(volatile int asked;
ISR(USART_UDRE_vect) { if (++asked == 5) UCSR0B &= ~_BV(UDRIE0); }
void setup() {
  UBRR0 = 16;
  UCSR0A = _BV(U2X0);
  UCSR0B = _BV(TXEN0) | _BV(RXEN0);
  UCSR0B |= _BV(UDRIE0);
  delay(20);
  uint8_t seen[9];
  for (int i = 0; i < 8; i += 2) {
    seen[i] = UCSR0A & (_BV(RXC0) | _BV(DOR0));
    seen[i + 1] = UDR0;
  }
  seen[8] = asked;
  UCSR0B = 0;
  Serial.begin(115200);
  for (int i = 0; i < 9; ++i) Serial.println(seen[i]);
}
void loop() {})");
  run(5 * kMillisecond);
  for (const std::uint8_t byte : {1, 2, 3, 4}) board().receive_byte(byte, now_);
  run(40 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(136, 1, 128, 2, 128, 4, 0, 4, 5));
}

TEST_F(Registers, WhatIsWrittenToAFullSenderIsIgnored) {
  EXPECT_EQ(output(R"(void setup() {
  UBRR0 = 16;
  UCSR0A = _BV(U2X0);
  UCSR0B = _BV(TXEN0);
  for (char c = '1'; c < '5'; ++c) UDR0 = c;
  delay(1);
  UDR0 = '5';
}
void loop() {})"),
            "125");
}

// Reads of UDR0 empty the receiver. Reads of SPSR and SPDR clear SPIF. A read of ADCH unlocks the ADC's
// result.
TEST_F(Registers, ARegisterThatIsAStatementIsRead) {
  start(R"(int drained;
void setup() {
  Serial.begin(115200);
  UCSR0B &= ~_BV(RXCIE0);
  delay(5);
  while (UCSR0A & _BV(RXC0)) {
    (void)UDR0;
    ++drained;
  }
  Serial.println(drained);
  DDRB = _BV(2);
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 1;
  while (!(SPSR & _BV(SPIF)));
  SPDR;
  Serial.println(SPSR >> SPIF);
  SPDR = 2;
  delayMicroseconds(20);
  SPSR;
  SPDR;
  Serial.println(SPSR >> SPIF);
  ADMUX = _BV(REFS0) | 14;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC));
  const uint8_t low = ADCL;
  (void)ADCH;
  ADMUX = _BV(REFS0) | 15;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC));
  Serial.println(low);
  Serial.println(ADC);
}
void loop() {})");
  run(2 * kMillisecond);
  for (const std::uint8_t byte : {'a', 'b'}) board().receive_byte(byte, now_);
  run(50 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(2, 0, 0, 225, 0));
}

TEST_F(Registers, NothingElseReadsThemTwice) {
  start(R"(void setup() {
  Serial.begin(115200);
  UCSR0B &= ~_BV(RXCIE0);
  delay(5);
  const uint8_t first = UDR0;
  Serial.println(first);
  Serial.println(UDR0);
  Serial.println(UDR0 + 1);
  delay(20);
  UDR0 = 'x';
  uint8_t last;
  last = UDR0 = 'y';
  Serial.println(last);
}
void loop() {})");
  run(2 * kMillisecond);
  for (const std::uint8_t byte : {'a', 'b', 'c'}) board().receive_byte(byte, now_);
  run(50 * kMillisecond);
  EXPECT_EQ(serial_, "97\r\n98\r\n100\r\nxy121\r\n");
}

// See the data sheet DS40002061B, 19.3.2.
TEST_F(Registers, SsAtLowLevelEndsAMaster) {
  output(R"(void tell() {
  Serial.println(SPCR);
  Serial.println(SPSR);
  SPSR;
  SPDR;
}
void setup() {
  Serial.begin(115200);
  DDRB = _BV(2);
  SPCR = _BV(SPE) | _BV(MSTR);
  tell();
  SPCR = 0;
  DDRB = 0;
  SPCR = _BV(SPE) | _BV(MSTR);
  tell();
  PORTB = _BV(2);
  SPCR = _BV(SPE) | _BV(MSTR);
  tell();
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(0x50, 0, 0x40, 0x80, 0x50, 0));
}

// The first conversion takes 25 ADC clocks of 8 us, and later conversions take 13 (DS40002061B, table 24-1).
TEST_F(Registers, TheFirstConversionBehindAdenTakes25Clocks) {
  output(R"(void convert() {
  const unsigned long start = micros();
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC));
  Serial.println((micros() - start + 4) / 8);
}
void setup() {
  Serial.begin(115200);
  ADMUX = _BV(REFS0) | 14;
  convert();
  convert();
  ADCSRA = 0;
  ADCSRA = _BV(ADEN) | 7;
  convert();
  convert();
  ADCSRA = 0;
  ADCSRA = _BV(ADEN) | 7;
  const unsigned long start = micros();
  analogRead(A0);
  Serial.println((micros() - start) / 8);
}
void loop() {})");
  const auto clocks = [](int count) { return testing::AllOf(testing::Ge(count), testing::Le(count + 2)); };
  EXPECT_THAT(numbers(), ElementsAre(clocks(25), clocks(13), clocks(25), clocks(13), clocks(25)));
}

TEST_F(Registers, WhatTheHostLacksIsTold) {
  output(
      "void setup() {\n  PRR = 0xFF & ~_BV(PRTIM0);\n  GPIOR0 = 7;\n  CLKPR = _BV(CLKPCE);\n  CLKPR = "
      "0;\n}\nvoid "
      "loop() {}");
  EXPECT_THAT(host_->lacks(), IsEmpty());
  output(
      "#include <avr/power.h>\nvoid setup() {\n  delay(5);\n  clock_prescale_set(clock_div_2);\n"
      "  clock_prescale_set(clock_div_4);\n}\nvoid loop() {}");
  ASSERT_THAT(host_->lacks(), SizeIs(1));
  EXPECT_EQ(host_->lacks()[0].what, "CLKPR");
  EXPECT_EQ(host_->lacks()[0].where.line, 4);
  EXPECT_NEAR(host_->lacks()[0].first_s, 0.005, 0.001);
}

TEST_F(Registers, PowerReductionIsLackingWhereItWouldStopATimerInUse) {
  output("void setup() {\n  PRR = _BV(PRTIM0);\n}\nvoid loop() {}");
  EXPECT_THAT(host_->lacks(), SizeIs(1));
  output("void setup() {\n  TCCR1B = 1;\n  PRR = _BV(PRTIM1);\n}\nvoid loop() {}");
  EXPECT_THAT(host_->lacks(), SizeIs(1));
  output("void setup() {\n  analogWrite(3, 9);\n  PRR = _BV(PRTIM2);\n}\nvoid loop() {}");
  EXPECT_THAT(host_->lacks(), SizeIs(1));
}

}  // namespace robosim::exec::registers_test
