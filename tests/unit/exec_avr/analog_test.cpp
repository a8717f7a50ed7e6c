// Tests the emulated AVR's ADC with sketches that run on a board.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace analog_test {

using testing::ElementsAre;

class AnalogTest : public AvrTest {};

TEST_F(AnalogTest, AReadingIsTheRatioToTheReferenceTimes1024) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(analogRead(A0)); Serial.println(analogRead(A1)); Serial.println(analogRead(A2));
  analogReference(INTERNAL);
  Serial.println(analogRead(A3));
}
void loop() {})");
  FixedSource third(5.0 / 3), all(5.0), none(0.0), half(0.55);
  board().connect(14, third);
  board().connect(15, all);
  board().connect(16, none);
  board().connect(17, half);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(341, 1023, 0, 512));
}

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
  // The conversion starts with the next ADC clock, whose period is 8 us.
  const auto sampled = static_cast<double>(source.asked_at[1]);
  EXPECT_NEAR(sampled - static_cast<double>(started), 16e3, 4.5e3);
  EXPECT_NEAR(static_cast<double>(ended) - sampled, 104e3 - 12e3, 1e3);
}

// Reads a pin with 4 V, then a pin with 1 V. With a source of 1 MOhm, the reading is too high by 24 to 43 %
// of the 3 V difference. In each further reading, 24 to 43 % of the previous error remain. A source of 10
// kOhm causes no error.
TEST_F(AnalogTest, AWeakSourceShiftsReadingsTowardsThePreviousChannel) {
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

TEST_F(AnalogTest, FreeRunningSamplesEvery104Microseconds) {
  start("void setup() { ADMUX = 0x40; ADCSRB = 0; ADCSRA = 0xE7; }\nvoid loop() {}");
  FixedSource source(2.0);
  board().connect(14, source);
  run(10 * kMillisecond);
  ASSERT_GT(source.asked_at.size(), 80u);
  EXPECT_NEAR(static_cast<double>(source.asked_at[50] - source.asked_at[10]) / 40, 104e3, 200.0);
}

TEST_F(AnalogTest, TheBandgapReadingDependsOnTheSupply) {
  EXPECT_EQ(output("void setup() { Serial.begin(115200); ADMUX = 0x4E; delay(2); ADCSRA |= _BV(ADSC); "
                   "while (ADCSRA & _BV(ADSC)) {} Serial.println(ADC); }\nvoid loop() {}"),
            "225\r\n");
}

}  // namespace analog_test
}  // namespace robosim::exec
