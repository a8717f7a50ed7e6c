// Tests digital and analog pins on the host, by functions and by registers.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec {
namespace pins_test {

using testing::ElementsAre;

class PinsTest : public HostTest {
 protected:
  /// Returns how `pin` is driven after `statements` in setup().
  PinDrive after(const std::string& statements, Pin pin) {
    start("void setup() { " + statements + " }\nvoid loop() {}");
    run(20 * kMillisecond);
    EXPECT_FALSE(host_->crash());
    return board().drive(pin);
  }
};

TEST_F(PinsTest, ModesAndLevelsReachTheBoard) {
  EXPECT_EQ(after("pinMode(7, OUTPUT);", 7).mode, PinMode::output);
  EXPECT_FALSE(board().drive(7).level);
  EXPECT_TRUE(after("pinMode(7, OUTPUT); digitalWrite(7, HIGH);", 7).level);
  EXPECT_EQ(after("pinMode(7, INPUT_PULLUP);", 7).mode, PinMode::input_pullup);
  EXPECT_EQ(after("digitalWrite(7, HIGH);", 7).mode, PinMode::input_pullup);
  EXPECT_EQ(after("pinMode(7, INPUT_PULLUP); pinMode(7, INPUT);", 7).mode, PinMode::input);
  EXPECT_TRUE(after("pinMode(A3, OUTPUT); digitalWrite(17, HIGH);", 17).level);
}

TEST_F(PinsTest, AnalogWriteGivesTheDutyOfThePinsTimer) {
  EXPECT_DOUBLE_EQ(after("analogWrite(5, 100);", 5).duty, 101.0 / 256);  // Timer 0: fast PWM
  EXPECT_DOUBLE_EQ(after("analogWrite(6, 1);", 6).duty, 2.0 / 256);
  EXPECT_DOUBLE_EQ(after("analogWrite(9, 100);", 9).duty, 100.0 / 255);  // Timers 1 and 2: phase correct
  EXPECT_DOUBLE_EQ(after("analogWrite(10, 254);", 10).duty, 254.0 / 255);
  EXPECT_DOUBLE_EQ(after("analogWrite(3, 7);", 3).duty, 7.0 / 255);
  EXPECT_TRUE(after("analogWrite(11, 128);", 11).pwm);
}

TEST_F(PinsTest, AnalogWriteOf0And255IsADigitalWrite) {
  for (const char* value : {"0", "255"}) {
    const PinDrive drive = after(std::string("analogWrite(9, 100); analogWrite(9, ") + value + ");", 9);
    EXPECT_FALSE(drive.pwm);
    EXPECT_EQ(drive.level, std::string(value) == "255");
    EXPECT_EQ(drive.duty, drive.level ? 1.0 : 0.0);
  }
}

TEST_F(PinsTest, AnalogWriteOutOfRangeIsCutAsTheRegisterCutsIt) {
  EXPECT_DOUBLE_EQ(after("analogWrite(5, 300);", 5).duty, 45.0 / 256);  // the register holds 300 & 255 = 44
  EXPECT_DOUBLE_EQ(after("analogWrite(5, -1 - 5);", 5).duty, 251.0 / 256);
  EXPECT_DOUBLE_EQ(after("analogWrite(9, 300);", 9).duty, 1.0);  // the 16-bit register holds 300, above TOP
  EXPECT_DOUBLE_EQ(after("analogWrite(9, -6);", 9).duty, 1.0);
}

TEST_F(PinsTest, AnalogWriteWithoutPwmHardwareIsAThresholdAt128) {
  EXPECT_FALSE(after("analogWrite(7, 127);", 7).level);
  EXPECT_TRUE(after("analogWrite(7, 128);", 7).level);
  EXPECT_FALSE(after("analogWrite(7, -20);", 7).level);
}

TEST_F(PinsTest, DigitalWriteAndDigitalReadEndPwm) {
  EXPECT_FALSE(after("analogWrite(9, 100); digitalWrite(9, HIGH);", 9).pwm);
  EXPECT_TRUE(board().drive(9).level);
  EXPECT_FALSE(after("analogWrite(9, 100); digitalRead(9);", 9).pwm);
}

TEST_F(PinsTest, DigitalReadGivesSourcesAndPullUps) {
  start(R"(void setup() {
  Serial.begin(115200);
  pinMode(2, INPUT); pinMode(3, INPUT_PULLUP); pinMode(4, INPUT); pinMode(5, INPUT); pinMode(6, OUTPUT);
  digitalWrite(6, HIGH);
  for (int pin = 2; pin <= 6; ++pin) Serial.println(digitalRead(pin));
  Serial.println(digitalRead(15));
}
void loop() {})");
  FixedSource high(5.0), low(0.0);
  board().connect(4, high);
  board().connect(5, low);
  board().connect(15, high);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 1, 1, 0, 1, 1));
}

TEST_F(PinsTest, AnalogReadTakesChannelsAndPinNumbers) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(analogRead(2));
  Serial.println(analogRead(A2));
  Serial.println(analogRead(16));
  Serial.println(analogRead(0));
  analogReference(INTERNAL);
  Serial.println(analogRead(1));
}
void loop() {})");
  FixedSource half(2.5), tenth(0.5), high(7.0);
  board().connect(16, half);
  board().connect(15, tenth);
  board().connect(14, high);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(512, 512, 512, 1023, 465));
}

TEST_F(PinsTest, ANanoHasTwoMoreAnalogPins) {
  board_name_ = "nano";
  start("void setup() { Serial.begin(115200); Serial.println(analogRead(A7)); } void loop() {}");
  FixedSource volts(5.0 * 700.5 / 1024);
  board().connect(21, volts);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(700));
}

TEST_F(PinsTest, AValueOutOfRangeHasTheEffectThatItHasOnTheBoardsOwnTimer) {
  const auto duty = [&](const char* board_name, int pin, const std::string& value) {
    board_name_ = board_name;
    start("volatile int value = " + value + "; void setup() { analogWrite(" + std::to_string(pin) +
          ", value); } void loop() {}");
    run(20 * kMillisecond);
    return std::lround(255 * board().drive(static_cast<Pin>(pin)).duty);
  };
  EXPECT_EQ(duty("mega", 5, "256"), 255) << "timer 3 has 16 bits";
  EXPECT_EQ(duty("mega", 5, "-1"), 255);
  EXPECT_EQ(duty("leonardo", 13, "300"), 44) << "timer 4 takes a byte";
  EXPECT_EQ(duty("bluepill", 8, "-30"), 0) << "the Blue Pill's core limits the value";
  EXPECT_EQ(duty("bluepill", 8, "300"), 255);
}

TEST_F(PinsTest, TheAdcSamplesWithinTheTickThatRuns) {
  start("void setup() {} void loop() { analogRead(A0); }");
  FixedSource volts(1.0);
  board().connect(14, volts);
  for (int tick = 1; tick <= 50; ++tick) {
    host_->run_until(tick * kTick);
    EXPECT_LT(volts.asked_at, tick * kTick);
    EXPECT_GE(volts.asked_at, (tick - 1) * kTick);
  }
}

TEST_F(PinsTest, RegistersArePins) {
  EXPECT_TRUE(after("DDRD |= _BV(7); PORTD |= _BV(7);", 7).level);
  EXPECT_FALSE(after("DDRB = 0xFF; PORTB = 0xFF; PORTB &= ~_BV(5);", 13).level);
  EXPECT_TRUE(board().drive(12).level);
  EXPECT_TRUE(after("DDRB = _BV(5); PINB = _BV(5);", 13).level);  // writing a one to PINx toggles
  EXPECT_DOUBLE_EQ(
      after("DDRB |= _BV(1); TCCR1A = _BV(COM1A1) | _BV(WGM11); TCCR1B = _BV(WGM13) | _BV(CS11); "
            "ICR1 = 20000; OCR1A = 1500;",
            9)
          .duty,
      1500.0 / 20000);
  EXPECT_DOUBLE_EQ(
      after("pinMode(3, OUTPUT); OCR2B = 63; TCCR2A = _BV(COM2B1) | _BV(COM2B0) | _BV(WGM20);", 3).duty,
      1.0 - 63.0 / 255);
}

TEST_F(PinsTest, InputRegistersReadTheWholePort) {
  start(
      "void setup() { Serial.begin(115200); Serial.println(PINC & 0x3F); Serial.println(bit_is_set(PIND, 2) "
      "!= 0); } void loop() {}");
  FixedSource high(5.0);
  board().connect(14, high);
  board().connect(17, high);
  board().connect(2, high);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(9, 1));
}

TEST_F(PinsTest, TheAdcWorksByItsRegistersToo) {
  start(R"(void setup() {
  Serial.begin(115200);
  ADMUX = _BV(REFS0) | 1;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC));
  Serial.println(ADC);
  ADMUX |= _BV(ADLAR);
  ADCSRA |= _BV(ADSC);
  while (bit_is_set(ADCSRA, ADSC));
  Serial.println(ADCH);
}
void loop() {})");
  FixedSource volts(2.5);
  board().connect(15, volts);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(512, 128));
}

TEST_F(PinsTest, ToneSoundsForItsTimeAndTakesTimer2) {
  start("void setup() { analogWrite(3, 50); tone(8, 440, 100); } void loop() {}");
  run(50 * kMillisecond);
  EXPECT_EQ(board().drive(8).tone_hz, 440u);
  EXPECT_FALSE(board().drive(3).pwm);
  run(100 * kMillisecond);
  EXPECT_EQ(board().drive(8).tone_hz, 0u);
  EXPECT_FALSE(board().drive(8).level);
  EXPECT_NEAR(static_cast<double>(changes(8).back() - changes(8).front()), 100e6, 1.5e6);
}

TEST_F(PinsTest, NoToneEndsATone) {
  EXPECT_EQ(after("tone(8, 1000); delay(5); noTone(8);", 8).tone_hz, 0u);
  EXPECT_EQ(after("tone(8, 1000); delay(5);", 8).tone_hz, 1000u);
}

TEST_F(PinsTest, ShiftOutClocksEachBitWithItsEdge) {
  start(
      "void setup() { pinMode(4, OUTPUT); pinMode(7, OUTPUT); shiftOut(7, 4, MSBFIRST, 0b10110010); } void "
      "loop() {}");
  run(20 * kMillisecond);
  std::string bits;
  bool data = false;
  for (const PinEvent& event : pins_) {
    if (event.pin == 7) data = event.drive.level;
    if (event.pin == 4 && event.drive.level) bits += data ? '1' : '0';
  }
  EXPECT_EQ(bits, "10110010");
}

TEST_F(PinsTest, PinsThatDoNotExistDoNoHarm) {
  EXPECT_EQ(
      after("pinMode(50, OUTPUT); digitalWrite(255, HIGH); analogWrite(-1, 7); digitalRead(60); tone(99, 3); "
            "attachInterrupt(9, setup, 1); pulseIn(77, 1); pinMode(13, OUTPUT);",
            13)
          .mode,
      PinMode::output);
}

TEST_F(PinsTest, NumbersAreThoseOfTheChip) {
  // The expected values are those that a build with gcc-avr 5.4 and avr-libc prints in simavr.
  output(R"(void setup() {
  Serial.begin(115200);
  randomSeed(42);
  for (int i = 0; i < 5; ++i) Serial.println(random(1000));
  Serial.println(rand());
  Serial.println(random(-5, 5));
  Serial.println(random());
  Serial.println(map(512, 0, 1023, -100, 100));
}
void loop() {})");
  EXPECT_THAT(numbers(), ElementsAre(894, 223, 9, 343, 826, 16807, -4, 2095673201, 0));
}

// Reads a pin with 4 V, then a pin with 1 V. With a source of 1 MOhm, the reading is too high by 24 to 43 %
// of the 3 V difference. In each further reading, 24 to 43 % of the previous error remain. A source of
// 10 kOhm causes no error.
TEST_F(PinsTest, AWeakSourceLeavesSomeOfTheChannelBeforeInAReading) {
  start(R"(void setup() {
  Serial.begin(115200);
  analogRead(A0);
  const int first = analogRead(A1), second = analogRead(A1);
  Serial.println(first);
  Serial.println(second);
  analogRead(A0);
  Serial.println(analogRead(A2));
}
void loop() {})");
  FixedSource high(4.0), weak(1.0, 1e6), strong(1.0, 10e3);
  board().connect(14, high);
  board().connect(15, weak);
  board().connect(16, strong);
  run(20 * kMillisecond);
  const auto found = numbers();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_GT(found[0], 204 + 0.20 * 614);
  EXPECT_LT(found[0], 204 + 0.45 * 614);
  EXPECT_LT(found[1], found[0] - 60);
  EXPECT_GT(found[1], 204);
  EXPECT_EQ(found[2], 204);
}

}  // namespace pins_test
}  // namespace robosim::exec
