// Tests register writes that disturb the regular period of timer 2. The same sketch on target avr printed the
// expected values.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::timer_turns_test {

using testing::SizeIs;

struct Step {
  int tick;  ///< time of `statement`, in ticks of 64 us since timer 2 started
  const char* statement;
};

class TimerTurns : public HostTest {
 protected:
  /// Starts timer 2 with all its registers 0, and executes `steps`. Returns "TCNT2 TIFR2 pins" after each
  /// statement. In "pins", bit 0 is OC2B and bit 1 is OC2A.
  std::string after(const std::vector<Step>& steps) {
    std::string sketch = R"(unsigned long t0;
int noted;
struct { uint8_t count, flags, pins; } notes[20];
void at(unsigned long tick) { while (micros() - t0 < tick * 64 + 24); }
void note() {
  notes[noted].flags = TIFR2;
  notes[noted].pins = (PIND >> 3 & 1) | (PINB >> 2 & 2);
  notes[noted++].count = TCNT2;
}
void setup() {
  Serial.begin(115200);
  pinMode(3, OUTPUT);
  pinMode(11, OUTPUT);
  TCCR2B = TCCR2A = OCR2A = OCR2B = TCNT2 = 0;
  delay(2);
  while (micros() & 60);
  GTCCR = _BV(PSRASY);
  TCCR2B = 7;
  t0 = micros();
  TIFR2 = 7;
)";
    for (const Step& step : steps)
      sketch += "  at(" + std::to_string(step.tick) + "); " + step.statement + " note();\n";
    return output(sketch + R"(  for (int i = 0; i < noted; ++i) {
    Serial.print(i ? ", " : "");
    Serial.print(notes[i].count);
    Serial.print(' ');
    Serial.print(notes[i].flags);
    Serial.print(' ');
    Serial.print(notes[i].pins);
  }
}
void loop() {})");
  }
};

// In PWM modes, new compare values take effect at the tick after TOP (data sheet, table 15-8).
TEST_F(TimerTurns, ValuesOfPwmAreTakenOverLater) {
  EXPECT_EQ(after({{5, "TCCR2A = 0xA3;"},
                   {10, "OCR2A = 20; OCR2B = 100; TIFR2 = 7;"},
                   {30, ""},
                   {120, ""},
                   {260, ""},
                   {278, "TIFR2 = 7;"},
                   {300, ""},
                   {301, "TCCR2A = 0xA1; OCR2A = 40; TIFR2 = 7;"},
                   {345, ""},
                   {520, ""},
                   {780, ""}}),
            "5 0 0, 10 0 0, 30 0 0, 120 0 0, 4 1 3, 22 0 1, 44 0 1, 45 0 1, 89 0 1, 246 4 0, 14 7 3");
}

TEST_F(TimerTurns, ATopBelowTheCountIsPassed) {
  EXPECT_EQ(after({{1, "OCR2A = 200; OCR2B = 230; TCCR2A = 2;"},
                   {100, "OCR2A = 50;"},
                   {210, ""},
                   {240, "TIFR2 = 7;"},
                   {258, ""},
                   {308, ""}}),
            "1 0 0, 100 0 0, 210 0 0, 240 0 0, 2 1 0, 1 3 0");
}

TEST_F(TimerTurns, ATopOfPwmChangesWithThePeriod) {
  EXPECT_EQ(after({{1, "OCR2A = 20; OCR2B = 5; TCCR2A = 0x23; TCCR2B = 15;"},
                   {10, "OCR2A = 8;"},
                   {19, ""},
                   {25, "TIFR2 = 7;"},
                   {29, ""},
                   {31, "TCCR2A = 0x21; OCR2A = 30;"},
                   {40, "TIFR2 = 7;"},
                   {50, ""},
                   {74, "OCR2A = 4;"},
                   {90, ""},
                   {130, ""}}),
            "1 0 1, 10 4 0, 19 4 0, 4 0 1, 8 4 0, 1 7 1, 6 0 0, 4 5 1, 28 5 0, 16 7 1, 0 7 1");
}

TEST_F(TimerTurns, AnotherModeKeepsTheCount) {
  EXPECT_EQ(after({{1, "OCR2A = 30; TCCR2A = 1; TCCR2B = 15;"},
                   {40, ""},
                   {41, "TCCR2A = 0; TCCR2B = 7; TIFR2 = 7;"},
                   {51, ""},
                   {52, "OCR2A = 60; TCCR2A = 1; TCCR2B = 15;"},
                   {62, ""}}),
            "1 0 0, 20 2 0, 19 0 0, 29 0 0, 30 0 0, 40 0 0");
}

// See the data sheet, 15.5.3.
TEST_F(TimerTurns, AWriteToTheCountHidesAMatch) {
  EXPECT_EQ(after({{1, "OCR2A = 30; OCR2B = 31; TCCR2A = 2; TIFR2 = 7;"},
                   {5, "TCNT2 = 30;"},
                   {6, ""},
                   {8, ""},
                   {10, "TCNT2 = 29;"},
                   {14, ""}}),
            "1 0 0, 30 0 0, 31 0 0, 33 4 0, 29 4 0, 2 6 0");
}

// See the data sheet, table 15-2 and 15.6.2.
TEST_F(TimerTurns, MatchesMakePinsWithoutPwm) {
  EXPECT_EQ(after({{1, "OCR2A = 40; OCR2B = 20; TCCR2A = 0xF0;"},
                   {10, ""},
                   {22, ""},
                   {50, "TCCR2A = 0xB0;"},
                   {60, "TCNT2 = 30;"},
                   {80, "TCCR2A = 0x10;"},
                   {200, "TCNT2 = 18;"},
                   {206, "TCCR2B = 0;"},
                   {220, ""}}),
            "1 0 0, 10 0 0, 22 4 1, 50 6 3, 30 6 3, 50 6 1, 18 6 1, 24 6 0, 24 6 0");
}

TEST_F(TimerTurns, TheBoardIsToldWhenTheyHappen) {
  start(R"(void setup() {
  TCCR1B = TCCR1A = 0;
  OCR1A = 2000;
  OCR1B = 0;
  DDRB = _BV(1) | _BV(2);
  TCCR1A = _BV(COM1A1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12);
  ICR1 = 39999;  // 20 ms
  TCNT1 = 0;
  TCCR1B |= _BV(CS11);
  delay(50);
  OCR1A = 4000;
  delay(30);
  TCCR1A = _BV(COM1B0);
  TCCR1B = _BV(WGM12) | _BV(CS12) | _BV(CS10);
  TCNT1 = 0;
  OCR1A = 1562;  // 100 ms
}
void loop() {})");
  run(500 * kMillisecond);
  std::vector<double> duties;
  std::vector<SimTime> times;
  for (const PinEvent& event : pins_) {
    if (event.pin != 9 || !event.drive.pwm) continue;
    duties.push_back(event.drive.duty);
    times.push_back(event.at);
  }
  ASSERT_THAT(duties, SizeIs(2));
  EXPECT_NEAR(duties[0], 0.05, 1e-3);
  EXPECT_NEAR(duties[1], 0.1, 1e-3);
  EXPECT_NEAR(1e-6 * static_cast<double>(times[1] - times[0]), 60.0, 0.1);
  std::vector<SimTime> toggles;
  for (const PinEvent& event : pins_)
    if (event.pin == 10 && !event.drive.pwm) toggles.push_back(event.at);
  ASSERT_GE(toggles.size(), 4u);
  EXPECT_NEAR(1e-6 * static_cast<double>(toggles.back() - toggles[toggles.size() - 2]), 100.0, 0.2);
}

}  // namespace robosim::exec::timer_turns_test
