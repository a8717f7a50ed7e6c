// The first test to read: it introduces the harness with which the tests of executors run a sketch.
//
// A test has four steps: write a sketch, connect voltages to its pins, let simulated time pass, and check
// what the sketch did. Nothing sleeps: a simulated second takes milliseconds, and gives the same result
// every time. To run only this test:
//
//   cmake --build build/ci --target targets_test
//   build/ci/tests/unit/targets/targets_test --gtest_filter='*HelloWorld*'
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::hello_world_test {

using testing::ElementsAre;

// TEST_P runs the test once for each target of its suite: on the host, on an emulated AVR, and on an emulated
// Cortex-M. Other suites run on some targets only (fixture.h). A name states what a user would notice.
TEST_P(OnEveryTarget, HelloWorld) {
  // start() compiles the sketch for the target, and switches the board on at time 0. Line 1 is the line of
  // `void setup()`, which matters in tests of reports that name lines.
  start(R"(void setup() {
  Serial.begin(115200);
  pinMode(13, OUTPUT);
}
void loop() {
  Serial.println(analogRead(A0));
  digitalWrite(13, HIGH);
  delay(30);
})");

  // A source gives a pin its voltage. The sketch has not run yet, so it finds the source at its first read.
  FixedSource half(supply() / 2);
  board().connect(pin("A0"), half);

  // Simulated time passes only within run(). Between two calls, reading the board changes nothing.
  EXPECT_EQ(drive("13").mode, PinMode::input);
  run(20 * kMillisecond);

  // serial_ holds the sketch's output, and numbers() returns its lines as numbers. Pins have names.
  EXPECT_EQ(serial_, "512\r\n");
  EXPECT_THAT(numbers(), ElementsAre(512));
  EXPECT_EQ(drive("13").mode, PinMode::output);
  EXPECT_TRUE(drive("13").level);

  // changes() returns the time of each change of a pin: the pin became an output, and then high.
  const std::vector<SimTime> times = changes(pin("13"));
  ASSERT_EQ(times.size(), 2u);
  EXPECT_LT(times[0], times[1]);

  // The sketch is still in its delay(). After the delay(), it prints a second time.
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(512, 512));
  EXPECT_FALSE(executor_->crash());
}

}  // namespace robosim::exec::hello_world_test

// The suites of this folder, and their targets.
namespace robosim::exec {

INSTANTIATE_TEST_SUITE_P(, OnEveryTarget, testing::ValuesIn(targets({"host", "avr", "stm32"})), name_of);
INSTANTIATE_TEST_SUITE_P(, OnEveryChip, testing::ValuesIn(targets({"avr", "stm32"})), name_of);
INSTANTIATE_TEST_SUITE_P(, OnAtmega, testing::ValuesIn(targets({"host", "avr"})), name_of);

}  // namespace robosim::exec
