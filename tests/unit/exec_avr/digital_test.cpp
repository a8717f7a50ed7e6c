// Tests digital pins and their interrupts on an emulated AVR.
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace digital_test {

using testing::ElementsAre;

class DigitalTest : public AvrTest {};

TEST_F(DigitalTest, ModesAndLevelsReachTheBoard) {
  start(R"(void setup() {
  pinMode(7, OUTPUT); digitalWrite(7, HIGH); pinMode(8, OUTPUT); pinMode(12, INPUT_PULLUP); pinMode(A3, OUTPUT);
  digitalWrite(A3, HIGH);
}
void loop() {})");
  run(2 * kMillisecond);
  EXPECT_TRUE(board().drive(7).level);
  EXPECT_EQ(board().drive(8).mode, PinMode::output);
  EXPECT_FALSE(board().drive(8).level);
  EXPECT_EQ(board().drive(12).mode, PinMode::input_pullup);
  EXPECT_TRUE(board().drive(17).level);
  EXPECT_EQ(board().drive(2).mode, PinMode::input);
}

TEST_F(DigitalTest, APinReadsItsSourceItsPullUpOrItsOwnOutput) {
  start(R"(void setup() {
  Serial.begin(115200);
  pinMode(4, INPUT_PULLUP); pinMode(5, INPUT_PULLUP); pinMode(7, OUTPUT); digitalWrite(7, HIGH);
  Serial.println(digitalRead(4) * 1000 + digitalRead(5) * 100 + digitalRead(6) * 10 + digitalRead(7));
}
void loop() {})");
  FixedSource low(0.0);
  board().connect(4, low);
  run(10 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(101));
}

TEST_F(DigitalTest, ADigitalReadSamplesOnlyItsPin) {
  start(
      "volatile byte n;\nvoid setup() { for (int i = 0; i < 10; ++i) n += digitalRead(4); }\nvoid loop() {}");
  FixedSource four(5.0), seven(5.0);
  board().connect(4, four);
  board().connect(7, seven);
  run(5 * kMillisecond);
  EXPECT_EQ(four.asked_at.size(), 10u);
  EXPECT_TRUE(seven.asked_at.empty());
}

TEST_F(DigitalTest, AWholePortIsReadAtOnce) {
  start("void setup() { Serial.begin(115200); Serial.println(PIND & 0xF0); }\nvoid loop() {}");
  FixedSource high(5.0);
  board().connect(4, high);
  board().connect(7, high);
  run(5 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(0x90));
}

TEST_F(DigitalTest, AnExternalInterruptRunsMicrosecondsAfterItsEdge) {
  start(R"(void seen() { PORTB |= _BV(5); }
void setup() { pinMode(13, OUTPUT); attachInterrupt(digitalPinToInterrupt(2), seen, RISING); }
void loop() {})");
  run(5 * kMillisecond);
  ASSERT_TRUE(board().wants_edges(2));
  const SimTime edge = now_ + 123456;
  board().schedule_edge(2, true, edge);
  run(kMillisecond);
  const SimTime delay = changes(13).back() - edge;
  EXPECT_GT(delay, 1 * kMicrosecond);
  EXPECT_LT(delay, 5 * kMicrosecond);
}

TEST_F(DigitalTest, EveryEdgeOfAnEncoderIsCountedWhileMotorsSwitchOnTheSamePort) {
  start(R"(volatile unsigned edges;
void count() { ++edges; }
void setup() {
  Serial.begin(115200);
  pinMode(2, INPUT_PULLUP); pinMode(4, OUTPUT); pinMode(5, OUTPUT);
  attachInterrupt(0, count, CHANGE);
  for (unsigned long end = millis() + 20; millis() < end;) { digitalWrite(4, !digitalRead(4)); analogWrite(5, edges); }
  Serial.println(edges);
}
void loop() {})");
  for (int tick = 0; tick < 10; ++tick) {
    run(kMillisecond);
    for (int i = 0; i < 10; ++i) board().schedule_edge(2, i % 2 == 0, now_ + i * 97 * kMicrosecond);
  }
  run(60 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(testing::AllOf(testing::Ge(98), testing::Le(100))));
}

TEST_F(DigitalTest, PinChangeInterruptsAreRequestedOnlyByEnabledPins) {
  start(R"(volatile int b, d;
ISR(PCINT0_vect) { ++b; }
ISR(PCINT2_vect) { ++d; }
void setup() {
  Serial.begin(115200);
  PCICR = 5; PCMSK0 = _BV(4); PCMSK2 = _BV(7);
  delay(20);
  Serial.println(b * 10 + d);
}
void loop() {})");
  run(5 * kMillisecond);
  EXPECT_TRUE(board().wants_edges(12));
  EXPECT_TRUE(board().wants_edges(7));
  EXPECT_FALSE(board().wants_edges(8));
  board().schedule_edge(12, true, now_ + 100 * kMicrosecond);
  board().schedule_edge(12, false, now_ + 200 * kMicrosecond);
  board().schedule_edge(7, true, now_ + 300 * kMicrosecond);
  run(50 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(21));
}

TEST_F(DigitalTest, PulseInMeasuresAnEcho) {
  start("void setup() { Serial.begin(115200); Serial.println(pulseIn(7, HIGH)); }\nvoid loop() {}");
  Pulse echo(3 * kMillisecond, 3 * kMillisecond + 1166 * kMicrosecond);
  board().connect(7, echo);
  run(20 * kMillisecond);
  EXPECT_THAT(numbers(), ElementsAre(testing::AllOf(testing::Ge(1154), testing::Le(1168))))
      << "pulseIn() counts iterations, and timer 0's interrupt delays some of them";
}

TEST_F(DigitalTest, WritingAOneToAPinRegisterTogglesThatPinAlone) {
  start("void setup() { DDRD = 0xF0; PORTD = 0x50; PIND |= 0x20; }\nvoid loop() {}");
  run(2 * kMillisecond);
  EXPECT_TRUE(board().drive(4).level);
  EXPECT_TRUE(board().drive(5).level);
  EXPECT_TRUE(board().drive(6).level);
  EXPECT_FALSE(board().drive(7).level);
}

}  // namespace digital_test
}  // namespace robosim::exec
