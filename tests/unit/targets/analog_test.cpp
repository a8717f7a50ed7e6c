// Tests analogRead() and the registers of the ADC.
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::analog_test {

using testing::ElementsAre;

TEST_P(OnEveryTarget, AReadingIsTheRatioToTheReferenceTimes1024) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(analogRead(A0)); Serial.println(analogRead(A1)); Serial.println(analogRead(A2));
}
void loop() {})");
  FixedSource third(supply() / 3), more(supply() + 2.0), none(0.0);
  board().connect(pin("A0"), third);
  board().connect(pin("A1"), more);
  board().connect(pin("A2"), none);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(341, 1023, 0));
}

TEST_P(OnAtmega, AnalogReadTakesChannelsAndPinNumbersAndTheInternalReference) {
  start(R"(void setup() {
  Serial.begin(115200);
  Serial.println(analogRead(2)); Serial.println(analogRead(A2)); Serial.println(analogRead(16));
  analogReference(INTERNAL);
  Serial.println(analogRead(1)); Serial.println(analogRead(A3));
}
void loop() {})");
  FixedSource half(2.5), tenth(0.5), half_of_internal(0.55);
  board().connect(pin("A1"), tenth);
  board().connect(pin("A2"), half);
  board().connect(pin("A3"), half_of_internal);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(512, 512, 512, 465, 512));
}

// Reads a pin with 4 V, then a pin with 1 V. With a source of 1 MOhm, the reading is too high by 24 to 43 %
// of the 3 V difference. In each further reading, 24 to 43 % of the previous error remains. A source of 10
// kOhm causes no error.
TEST_P(OnAtmega, AWeakSourceShiftsReadingsTowardsThePreviousChannel) {
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
  board().connect(pin("A0"), high);
  board().connect(pin("A1"), weak);
  board().connect(pin("A2"), strong);
  run(20 * kMillisecond);
  const auto found = numbers();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_GT(found[0], 204 + 0.20 * 614);
  EXPECT_LT(found[0], 204 + 0.45 * 614);
  EXPECT_LT(found[1], found[0] - 60);
  EXPECT_GT(found[1], 204);
  EXPECT_EQ(found[2], 204);
}

}  // namespace robosim::exec::analog_test
