// Tests millis(), micros(), delay() and the other functions of time on the host.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::time_test {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;
using testing::SizeIs;

using TimeTest = HostTest;

TEST_F(TimeTest, MicrosCountsInStepsOfFour) {
  output(R"(void setup() { Serial.begin(115200); for (int i = 0; i < 20; ++i) Serial.println(micros() % 4); }
void loop() {})");
  EXPECT_THAT(numbers(), AllOf(SizeIs(20), Each(0)));
}

TEST_F(TimeTest, MillisGoesOnWithTimer0AndSkipsOneOf43) {
  // Timer 0 overflows every 1.024 ms. After 42 overflows, the fractions add up to one millisecond (wiring.c).
  EXPECT_THAT(printed(R"(
  unsigned long last = millis(), steps = 0, skips = 0;
  while (steps < 430) {
    const unsigned long now = millis();
    if (now == last) continue;
    if (now - last == 2) ++skips;
    last = now;
    ++steps;
  }
  Serial.println(skips);)"),
              ElementsAre(testing::AnyOf(10, 11)));
}

TEST_F(TimeTest, MillisKeepsPaceWithSimulatedTime) {
  start(
      "void setup() { pinMode(13, OUTPUT); while (millis() < 5000); digitalWrite(13, HIGH); } void loop() "
      "{}");
  run(6 * kSecond);
  ASSERT_EQ(changes(13).size(), 2u);
  EXPECT_NEAR(static_cast<double>(changes(13)[1]), 5e9, 2e6);
}

TEST_F(TimeTest, ASketchThatIsLateIsSoFromThereOnAndItsClockGoesOn) {
  lateness_ = {{0, 400'000}, {25'000'000, 2'500'000}, {42'000'000, -1'500'000}};
  output(R"(void setup() { Serial.begin(115200); Serial.println(micros()); }
void loop() { delay(10); Serial.println(micros()); })",
         kSecond / 10);
  const std::vector<long long> said = numbers();
  ASSERT_GE(said.size(), 6u);
  const long long round = said[3] - said[2];
  EXPECT_NEAR(static_cast<double>(round), 10'200, 200);
  EXPECT_NEAR(static_cast<double>(said[0]), 410, 20) << "start-up time before setup()";
  EXPECT_NEAR(static_cast<double>(said[4] - said[3]), static_cast<double>(round + 2500), 40);
  EXPECT_NEAR(static_cast<double>(said[5] - said[4]), static_cast<double>(round - 1500), 40);
}

TEST_F(TimeTest, DelayTakesItsMillisecondsAndAFewMicroseconds) {
  start(
      "void setup() { pinMode(13, OUTPUT); } void loop() { digitalWrite(13, HIGH); delay(10); "
      "digitalWrite(13, LOW); delay(1); }");
  run(kSecond);
  const std::vector<SimTime> times = changes(13);
  ASSERT_GT(times.size(), 100u);
  for (std::size_t i = 1; i + 2 < times.size(); i += 2) {
    EXPECT_NEAR(static_cast<double>(times[i + 1] - times[i]), 10.014e6, 8e3);
    EXPECT_NEAR(static_cast<double>(times[i + 2] - times[i + 1]), 1.014e6, 8e3);
  }
}

TEST_F(TimeTest, ADelayOfHoursIsOneStep) {
  start("void setup() { delay(3600000UL * 10); pinMode(13, OUTPUT); } void loop() {}");
  host_->run_until(35999 * kSecond);
  EXPECT_TRUE(pins_.empty());
  host_->run_until(36001 * kSecond);
  EXPECT_EQ(pins_.size(), 1u);
}

TEST_F(TimeTest, DelayMicrosecondsIsBusyAndExact) {
  EXPECT_THAT(printed(R"(
  unsigned long start = micros();
  delayMicroseconds(500);
  Serial.println(micros() - start);)"),
              ElementsAre(AllOf(Ge(500), Le(512))));
}

TEST_F(TimeTest, ReadsInARowTakeFourteenAdcClocks) {
  EXPECT_THAT(printed(R"(
  unsigned long start = micros();
  for (int i = 0; i < 1000; ++i) analogRead(A0);
  Serial.println(micros() - start);)"),
              ElementsAre(AllOf(Ge(111900), Le(112500))));
}

TEST_F(TimeTest, TimePassesInEveryWayOfWaiting) {
  for (const char* wait :
       {"while (!flag);", "while (millis() < 4000000000UL);", "while (digitalRead(2) == LOW);",
        "while (!Serial.available());", "while (!(PIND & 4));", "while (true) {}", "for (;;);",
        "delay(1000000000);", "pulseIn(2, HIGH, 4000000000UL);", "noInterrupts(); while (true);"}) {
    SCOPED_TRACE(wait);
    pins_.clear();
    start(std::string("volatile bool flag;\nvoid setup() { Serial.begin(9600); ") + wait +
          " pinMode(13, OUTPUT); }\nvoid loop() {}");
    run(20 * kMillisecond);
    EXPECT_FALSE(host_->crash());
    EXPECT_TRUE(pins_.empty());
    EXPECT_EQ(host_->activity().where.file, "Test.ino");
    EXPECT_EQ(host_->activity().where.line, 2);
  }
}

TEST_F(TimeTest, WithInterruptsOffADelayEndsEarlyAsOnTheChip) {
  // With interrupts off, micros() jumps back when timer 0 overflows again. In simavr, delay(1000) then takes
  // 98,041 cycles.
  start(
      "void setup() { noInterrupts(); pinMode(12, OUTPUT); delay(1000); pinMode(13, OUTPUT); } void loop() "
      "{}");
  run(kSecond);
  ASSERT_EQ(pins_.size(), 2u);
  EXPECT_NEAR(static_cast<double>(pins_[1].at - pins_[0].at), 98041 * 62.5, 1.1e6);
}

TEST_F(TimeTest, ItIsKnownWhatFirmwareWaitsFor) {
  start("void setup() {}\nvoid loop() {\n  while (digitalRead(2) == LOW);\n}\n");
  run(100 * kMillisecond);
  const Activity activity = host_->activity();
  EXPECT_EQ(activity.call, "digitalRead(2)");
  EXPECT_EQ(activity.pin, 2);
  EXPECT_GT(activity.last_call, 99 * kMillisecond);
  EXPECT_EQ(activity.where.function, "loop");
  EXPECT_EQ(activity.where.line, 3);
}

TEST_F(TimeTest, FirmwareThatCallsNothingIsInNoCall) {
  for (const char* call : {"", "pinMode(13, OUTPUT);"}) {
    start(std::string("void setup() {") + call + "}\nvoid loop() {}\n");
    run(100 * kMillisecond);
    EXPECT_EQ(host_->activity().call, "") << "the call of setup() has returned";
    EXPECT_EQ(host_->activity().where.function, "loop");
  }
}

TEST_F(TimeTest, FirmwareInALongDelayHasNotHung) {
  start("void setup() { delay(60000); } void loop() {}");
  run(5 * kSecond);
  EXPECT_EQ(host_->last_call(), 5 * kSecond);
}

TEST_F(TimeTest, FirmwareInAnEmptyLoopCallsNothing) {
  start("void setup() { digitalRead(2); while (true); } void loop() {}");
  run(5 * kSecond);
  EXPECT_LT(host_->last_call(), kMillisecond);
}

}  // namespace robosim::exec::time_test
