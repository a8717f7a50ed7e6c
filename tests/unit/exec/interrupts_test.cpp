// Tests interrupts on the host: attachInterrupt(), pin changes, flags and cli().
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::interrupts_test {

using testing::ElementsAre;

class InterruptsTest : public HostTest {
 protected:
  /// Switches the board on and runs it for 10 ms, so that setup() can attach its handlers.
  void prepare(const std::string& text) {
    start(text);
    run(10 * kMillisecond);
  }
};

TEST_F(InterruptsTest, AVolatileFlagSetByAHandlerEndsALoop) {
  prepare(R"(volatile bool flag;
void pressed() { flag = true; }
void setup() { Serial.begin(115200); attachInterrupt(digitalPinToInterrupt(2), pressed, RISING); while (!flag); Serial.println(7); }
void loop() {})");
  EXPECT_TRUE(board().wants_edges(2));
  EXPECT_FALSE(board().wants_edges(3));
  EXPECT_EQ(serial_, "");
  board().schedule_edge(2, true, now_ + 300 * kMicrosecond);
  run(kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(7));
  EXPECT_NEAR(static_cast<double>(byte_times_[0]), 10.3e6, 100e3);
}

TEST_F(InterruptsTest, AHandlerDoesNotChangeThePlaceOfTheCallThatItInterrupts) {
  prepare(
      "void tick() { digitalWrite(5, HIGH); }\n"
      "void setup() { attachInterrupt(0, tick, RISING); }\n"
      "void loop() {\n  delay(400);\n}\n");
  board().schedule_edge(2, true, now_ + 300 * kMicrosecond);
  run(20 * kMillisecond);
  EXPECT_EQ(board().drive(5).mode, PinMode::input_pullup) << "the handler has run";
  EXPECT_EQ(host_->activity().call, "delay(400)");
  EXPECT_EQ(host_->activity().where.line, 4);
}

TEST_F(InterruptsTest, TheCallOfALongDelayHasAnUnsignedNumber) {
  prepare("void setup() {}\nvoid loop() { delay(4000000000UL); }\n");
  run(20 * kMillisecond);
  EXPECT_EQ(host_->activity().call, "delay(4000000000)");
}

TEST_F(InterruptsTest, AttachingToAPinThatIsHighIsNoEdge) {
  start(R"(volatile int count;
void tick() { ++count; }
void setup() { Serial.begin(115200); attachInterrupt(0, tick, RISING); delay(5); Serial.println(count); } void loop() {})");
  FixedSource high(5.0);
  board().connect(2, high);
  run(kMillisecond);
  for (int i = 0; i < 3; ++i) board().schedule_edge(2, true, now_ + i * 100 * kMicrosecond);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0));
}

// The chip also remembers the edge, because attachInterrupt() does not clear the flag (data sheet, 13.2.3,
// 13.2.5).
TEST_F(InterruptsTest, AnEdgeBeforeTheInterruptIsEnabledIsRemembered) {
  prepare(R"(volatile int count;
void tick() { ++count; }
ISR(PCINT2_vect) { count += 10; }
void setup() {
  Serial.begin(115200);
  attachInterrupt(0, tick, RISING);
  detachInterrupt(0);
  PCMSK2 = _BV(3);
  delay(50);
  Serial.println(EIFR);
  Serial.println(PCIFR);
  attachInterrupt(0, tick, RISING);
  delayMicroseconds(1);
  Serial.println(count);
  Serial.println(EIFR);
  PCICR = _BV(PCIE2);
  delayMicroseconds(1);
  Serial.println(count);
}
void loop() {})");
  board().schedule_edge(2, true, now_ + kMillisecond);
  board().schedule_edge(3, true, now_ + kMillisecond);
  run(80 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 4, 1, 0, 11));
}

TEST_F(InterruptsTest, AFlagIsClearedByWritingOneAndByMakingItALevels) {
  prepare(R"(volatile int count;
void tick() { ++count; }
void setup() {
  Serial.begin(115200);
  EICRA = 15;
  delay(50);
  Serial.println(EIFR);
  EIFR = 1;
  Serial.println(EIFR);
  EICRA = 0;
  Serial.println(EIFR);
  attachInterrupt(1, tick, RISING);
  delay(1);
  Serial.println(count);
}
void loop() {})");
  board().schedule_edge(2, true, now_ + kMillisecond);
  board().schedule_edge(3, true, now_ + kMillisecond);
  run(80 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(3, 2, 0, 0));
}

TEST_F(InterruptsTest, WithInterruptsOffTheEdgeWaits) {
  prepare(R"(volatile int count;
void tick() { ++count; }
void setup() {
  Serial.begin(115200);
  attachInterrupt(0, tick, RISING);
  noInterrupts();
  for (volatile long i = 0; i < 20000; ++i);
  const int before = count;
  interrupts();
  Serial.println(before);
  Serial.println(count);
}
void loop() {})");
  board().schedule_edge(2, true, now_ + 100 * kMicrosecond);
  run(500 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0, 1));
}

TEST_F(InterruptsTest, HandlersAreNotInterrupted) {
  prepare(R"(volatile int depth, deepest;
void slow() { if (++depth > deepest) deepest = depth; for (volatile int i = 0; i < 200; ++i); --depth; }
void setup() { Serial.begin(115200); attachInterrupt(0, slow, CHANGE); attachInterrupt(1, slow, CHANGE); delay(50); Serial.println(deepest); }
void loop() {})");
  for (int i = 0; i < 8; ++i) board().schedule_edge(i % 2 ? 2 : 3, i % 4 < 2, now_ + i * 20 * kMicrosecond);
  run(60 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1));
}

TEST_F(InterruptsTest, MillisStandsStillWhileInterruptsAreOff) {
  EXPECT_THAT(printed(R"(
  noInterrupts();
  const unsigned long before = millis();
  delayMicroseconds(10000);
  const unsigned long after = millis();
  interrupts();
  Serial.println(after - before);)"),
              ElementsAre(0));
}

TEST_F(InterruptsTest, ALowLevelInterruptsAgainAndAgainButLetsTheSketchGoOn) {
  prepare(R"(volatile long count;
void tick() { ++count; }
void setup() { Serial.begin(115200); attachInterrupt(0, tick, LOW); for (volatile int i = 0; i < 100; ++i); detachInterrupt(0); Serial.println(count > 50); }
void loop() {})");
  run(50 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(1));
}

TEST_F(InterruptsTest, EdgesAreWantedAsLongAsTheyCanSetAFlag) {
  prepare("void f() {} void setup() { attachInterrupt(0, f, CHANGE); detachInterrupt(0); } void loop() {}");
  EXPECT_TRUE(board().wants_edges(2)) << "EICRA is unchanged";
  prepare(
      "void f() {} void setup() { attachInterrupt(0, f, CHANGE); detachInterrupt(0); EICRA = 0; } void "
      "loop() "
      "{}");
  EXPECT_FALSE(board().wants_edges(2));
}

TEST_F(InterruptsTest, AnEmptyLoopServesHandlersForEver) {
  prepare(R"(volatile int count;
void tick() { ++count; digitalWrite(13, count & 1); }
void setup() { pinMode(13, OUTPUT); attachInterrupt(0, tick, RISING); for (;;); }
void loop() {})");
  for (int i = 0; i < 6; ++i) board().schedule_edge(2, i % 2 == 0, now_ + (i + 1) * 100 * kMicrosecond);
  run(kMillisecond);
  EXPECT_EQ(changes(13).size(), 4u);
  EXPECT_LT(host_->last_call(), 10 * kMillisecond);
}

TEST_F(InterruptsTest, WhereAnInterruptOfTheChipAloneIsEnabledNothingHangs) {
  const std::pair<const char*, bool> kSetups[] = {
      {"ACSR = _BV(ACIE);", false}, {"EECR |= _BV(EERIE);", false}, {"ACSR = _BV(ACD) | _BV(ACIE);", true}};
  for (const auto& [setup, hangs] : kSetups) {
    SCOPED_TRACE(setup);
    start(std::string("volatile byte n;\nISR(ANALOG_COMP_vect) { ++n; }\nISR(EE_READY_vect) { ++n; }\n") +
          "void setup() { " + setup + " while (!n); }\nvoid loop() {}\n");
    run(2 * kSecond);
    EXPECT_EQ(host_->hangs(), hangs);
  }
}

}  // namespace robosim::exec::interrupts_test
