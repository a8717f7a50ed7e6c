// Tests PWM, tones and pulses of an emulated AVR.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace pwm_test {

class PwmTest : public AvrTest {
 protected:
  PinDrive after(const std::string& statements, Pin pin) {
    start("void setup() { " + statements + " }\nvoid loop() {}");
    run(3 * kMillisecond);
    EXPECT_FALSE(avr_->crash());
    return board().drive(pin);
  }
};

TEST_F(PwmTest, AnalogWriteGivesTheDutyOfThePinsTimer) {
  const std::string all =
      "analogWrite(5, 100); analogWrite(6, 1); analogWrite(9, 100); analogWrite(10, 254); "
      "analogWrite(3, 7); analogWrite(11, 128);";
  EXPECT_DOUBLE_EQ(after(all, 5).duty, 101.0 / 256);  // timer 0: fast PWM
  EXPECT_DOUBLE_EQ(board().drive(6).duty, 2.0 / 256);
  EXPECT_DOUBLE_EQ(board().drive(9).duty, 100.0 / 255);  // timers 1 and 2: phase correct
  EXPECT_DOUBLE_EQ(board().drive(10).duty, 254.0 / 255);
  EXPECT_DOUBLE_EQ(board().drive(3).duty, 7.0 / 255);
  EXPECT_DOUBLE_EQ(board().drive(11).duty, 128.0 / 255);
  EXPECT_TRUE(board().drive(11).pwm);
}

TEST_F(PwmTest, AnalogWriteOf0And255IsADigitalWrite) {
  EXPECT_FALSE(
      after("analogWrite(9, 100); analogWrite(9, 0); analogWrite(5, 9); analogWrite(5, 255);", 9).pwm);
  EXPECT_EQ(board().drive(9).duty, 0.0);
  EXPECT_FALSE(board().drive(5).pwm);
  EXPECT_EQ(board().drive(5).duty, 1.0);
}

TEST_F(PwmTest, TimerOneAt20kHzHasItsOwnTop) {
  // In phase-correct mode with TOP = ICR1 = 400, the frequency is 16 MHz / 800 = 20 kHz.
  EXPECT_DOUBLE_EQ(
      after("pinMode(9, OUTPUT); pinMode(10, OUTPUT); TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM11); "
            "TCCR1B = _BV(WGM13) | _BV(CS10); ICR1 = 400; OCR1A = 300; OCR1B = 100;",
            9)
          .duty,
      0.75);
  EXPECT_DOUBLE_EQ(board().drive(10).duty, 0.25);
}

TEST_F(PwmTest, FastPwmOfTimerOneCountsTopAsAStep) {
  EXPECT_DOUBLE_EQ(
      after("pinMode(9, OUTPUT); TCCR1A = _BV(COM1A1) | _BV(WGM11); TCCR1B = _BV(WGM13) | _BV(WGM12) | "
            "_BV(CS10); ICR1 = 799; OCR1A = 199;",
            9)
          .duty,
      0.25);
}

TEST_F(PwmTest, AToneIsItsEdges) {
  start("void setup() { tone(8, 440, 100); }\nvoid loop() {}");
  run(150 * kMillisecond);
  const auto edges = changes(8);
  ASSERT_GT(edges.size(), 80u);
  const double period = 2e-9 * static_cast<double>(edges[70] - edges[10]) / 60.0;
  EXPECT_NEAR(1.0 / period, 440.0, 2.0);
  EXPECT_FALSE(board().drive(8).level) << "silent after 100 ms";
}

TEST_F(PwmTest, ACompareInterruptMakesAServosPulse) {
  start(R"(ISR(TIMER1_COMPA_vect) { PORTB &= ~_BV(2); }
ISR(TIMER1_OVF_vect) { PORTB |= _BV(2); }
void setup() { pinMode(10, OUTPUT); TCCR1A = 0; TCCR1B = _BV(CS11); OCR1A = 3000; TIMSK1 = _BV(OCIE1A) | _BV(TOIE1); }
void loop() {})");
  run(200 * kMillisecond);
  std::vector<SimTime> high, low;
  for (const PinEvent& event : pins_)
    if (event.pin == 10 && event.at > 10 * kMillisecond) (event.drive.level ? high : low).push_back(event.at);
  ASSERT_GE(high.size(), 4u);
  EXPECT_NEAR(static_cast<double>(high[1] - high[0]), 32.768e6, 4e3);
  EXPECT_NEAR(static_cast<double>(low[low[0] > high[0] ? 0 : 1] - high[0]), 1500e3, 10e3);
}

}  // namespace pwm_test
}  // namespace robosim::exec
