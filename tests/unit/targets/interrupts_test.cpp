// Tests attachInterrupt() and pin change interrupts.
#include "tests/unit/targets/fixture.h"

namespace robosim::exec::interrupts_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;

TEST_P(OnAtmega, AnExternalInterruptRunsMicrosecondsAfterItsEdge) {
  start(R"(void seen() { PORTB |= _BV(5); }
void setup() { pinMode(13, OUTPUT); attachInterrupt(digitalPinToInterrupt(2), seen, RISING); }
void loop() {})");
  run(5 * kMillisecond);
  ASSERT_TRUE(board().wants_edges(pin("2")));
  EXPECT_FALSE(board().wants_edges(pin("3")));
  const SimTime edge = now_ + 123456;
  board().schedule_edge(pin("2"), true, edge);
  run(kMillisecond);
  const SimTime delay = changes(pin("13")).back() - edge;
  EXPECT_GT(delay, 1 * kMicrosecond);
  EXPECT_LT(1e-3 * static_cast<double>(delay), GetParam().handler_us);
}

TEST_P(OnEveryTarget, AHandlerRunsAtItsEdgeEvenInADelay) {
  start(R"(void mark() { digitalWrite(13, !digitalRead(13)); }
void setup() { pinMode(13, OUTPUT); attachInterrupt(digitalPinToInterrupt(2), mark, CHANGE); delay(100000); }
void loop() {})");
  run(10 * kMillisecond);
  const SimTime edge = now_ + 2 * kMillisecond + 345 * kMicrosecond;
  board().schedule_edge(pin("2"), true, edge);
  run(3 * kMillisecond);
  const std::vector<SimTime> times = changes(pin("13"));
  ASSERT_EQ(times.size(), 2u);
  EXPECT_GT(times[1], edge);
  EXPECT_LT(times[1], edge + 25 * kMicrosecond);
}

TEST_P(OnEveryTarget, OnlyTheWantedEdgesCount) {
  for (const auto& [mode, expected] : {std::pair{"RISING", 3L}, {"FALLING", 2L}, {"CHANGE", 5L}}) {
    start(std::string(R"(volatile int count;
void tick() { ++count; }
void setup() { Serial.begin(115200); attachInterrupt(digitalPinToInterrupt(3), tick, )") +
          mode + "); delay(20); Serial.println(count); } void loop() {}");
    run(10 * kMillisecond);
    for (int i = 0; i < 5; ++i)
      board().schedule_edge(pin("3"), i % 2 == 0, now_ + (i + 1) * 100 * kMicrosecond);
    run(20 * kMillisecond);
    EXPECT_THAT(numbers(), ElementsAre(expected)) << mode;
  }
}

TEST_P(OnEveryTarget, EveryEdgeOfAnEncoderIsCountedWhileMotorsSwitch) {
  start(R"(volatile unsigned edges;
void count() { ++edges; }
void setup() {
  Serial.begin(115200);
  pinMode(2, INPUT_PULLUP); pinMode(4, OUTPUT); pinMode(5, OUTPUT);
  attachInterrupt(digitalPinToInterrupt(2), count, CHANGE);
  for (unsigned long end = millis() + 20; millis() < end;) { digitalWrite(4, !digitalRead(4)); analogWrite(5, edges); }
  Serial.println(edges);
}
void loop() {})");
  run(3 * kMillisecond);
  for (int tick = 0; tick < 10; ++tick) {
    run(kMillisecond);
    for (int i = 0; i < 10; ++i) board().schedule_edge(pin("2"), i % 2 == 0, now_ + i * 97 * kMicrosecond);
  }
  run(60 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(AllOf(Ge(98), Le(100))));
}

TEST_P(OnAtmega, PinChangeInterruptsAreRequestedOnlyByEnabledPins) {
  start(R"(volatile int port_b, port_d;
ISR(PCINT0_vect) { ++port_b; }
ISR(PCINT2_vect) { ++port_d; }
void setup() {
  Serial.begin(115200);
  PCMSK0 = _BV(PCINT4);
  PCMSK2 = _BV(PCINT23);
  PCICR = _BV(PCIE0) | _BV(PCIE2);
  delay(20);
  Serial.println(port_b);
  Serial.println(port_d);
}
void loop() {})");
  run(5 * kMillisecond);
  EXPECT_TRUE(board().wants_edges(pin("12")));
  EXPECT_TRUE(board().wants_edges(pin("7")));
  EXPECT_FALSE(board().wants_edges(pin("8")));
  board().schedule_edge(pin("12"), true, now_ + 100 * kMicrosecond);
  board().schedule_edge(pin("12"), false, now_ + 200 * kMicrosecond);
  board().schedule_edge(pin("7"), true, now_ + 300 * kMicrosecond);
  run(50 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(2, 1));
}

}  // namespace robosim::exec::interrupts_test
