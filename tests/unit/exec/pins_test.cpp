// Tests digital and analog pins on the host, by functions and by registers.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::pins_test {

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
    EXPECT_LT(volts.asked_at.back(), tick * kTick);
    EXPECT_GE(volts.asked_at.back(), (tick - 1) * kTick);
  }
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
  EXPECT_THAT(printed(R"(
  randomSeed(42);
  for (int i = 0; i < 5; ++i) Serial.println(random(1000));
  Serial.println(rand());
  Serial.println(random(-5, 5));
  Serial.println(random());
  Serial.println(map(512, 0, 1023, -100, 100));)"),
              ElementsAre(894, 223, 9, 343, 826, 16807, -4, 2095673201, 0));
}

}  // namespace robosim::exec::pins_test
