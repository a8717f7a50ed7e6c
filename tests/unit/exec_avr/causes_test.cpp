// Tests tracing the level of a pin back to the lines of the sketch that caused it.
#include <map>

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::causes_test {

using testing::AllOf;
using testing::Contains;
using testing::IsSupersetOf;
using testing::Key;
using testing::Not;

constexpr Pin kA2 = 16;

constexpr const char* kSketch = R"(volatile int scale = 3;
volatile int raw, turn, shown;
void steer() {
  analogWrite(5, turn);
}
void setup() {
  pinMode(5, OUTPUT);
}
void loop() {
  raw = analogRead(A2);
  turn = scale;
  if (raw > 300)
    turn = raw / 8;

  shown = analogRead(A3);
  steer();
  delay(1);
})";

class CausesTest : public AvrTest {
 protected:
  void before_power_on() override {
    causes_ = avr_->find_causes();
    ASSERT_NE(causes_, nullptr);
  }
  /// Runs a sketch with this voltage at pin A2. Returns the causes of the final level of pin 5. The keys are
  /// line numbers of the sketch.
  std::map<int, CauseStep> lines_behind_pin_5(double volts, const std::string& sketch) {
    FixedSource sensor(volts);
    start(sketch);
    board().connect(kA2, sensor);
    causes_->begin();
    run(8 * kMillisecond);
    causes_->end();
    causes_->ask({.pins = {5}}, now_);
    causes_->follow(true);
    causes_->close();
    return by_line();
  }
  /// Returns the steps of the causal chain, with their line numbers as keys. If a line has several steps, a
  /// step of kind `reads` has priority.
  std::map<int, CauseStep> by_line() const {
    std::map<int, CauseStep> lines;
    for (const CauseStep& step : causes_->steps()) {
      const auto [known, fresh] = lines.try_emplace(step.where.line, step);
      if (step.kind == CauseStep::Kind::reads) known->second = step;
    }
    return lines;
  }

  CauseFinder* causes_ = nullptr;
};

std::vector<int> numbers_of(const std::map<int, CauseStep>& lines) {
  std::vector<int> numbers;
  for (const auto& [line, step] : lines) numbers.push_back(line);
  return numbers;
}

TEST_F(CausesTest, LeadFromThePinToTheReading) {
  const auto lines = lines_behind_pin_5(3.0, kSketch);
  EXPECT_THAT(numbers_of(lines), IsSupersetOf({4, 10, 12, 13, 16}));
  EXPECT_THAT(lines, AllOf(Not(Contains(Key(11))), Not(Contains(Key(15))), Not(Contains(Key(1)))))
      << "lines without an effect on the pin, and lines whose effect was overwritten";
  EXPECT_EQ(lines.at(10).kind, CauseStep::Kind::reads);
  EXPECT_EQ(lines.at(10).pin, kA2);
  EXPECT_EQ(lines.at(12).kind, CauseStep::Kind::decides);
  EXPECT_LT(lines.at(4).far, lines.at(13).far);
  EXPECT_GT(lines.at(13).t, 5 * kMillisecond) << "the last execution of the line";
}

TEST_F(CausesTest, LeadToAVariableThatHasWhatItBeganWith) {
  const auto lines = lines_behind_pin_5(0.5, kSketch);
  EXPECT_THAT(numbers_of(lines), IsSupersetOf({1, 4, 11, 16}));
  EXPECT_THAT(lines, Not(Contains(Key(13))));
  EXPECT_EQ(lines.at(1).kind, CauseStep::Kind::keeps);
}

// Records the second half of a run, and traces the causes back to the beginning of this half. Then restores
// the start of the run, records the first half, and traces the causes to their origin.
TEST_F(CausesTest, AreFollowedThroughWhatWasNotedApart) {
  FixedSource sensor(3.0);
  start(R"(volatile int gain;
void setup() {
  pinMode(5, OUTPUT);
  gain = analogRead(A2) / 16;
}
void loop() {
  analogWrite(5, gain);
  delay(1);
})");
  board().connect(kA2, sensor);
  const std::any beginning = avr_->save();
  run(10 * kMillisecond);
  causes_->begin();
  run(10 * kMillisecond);
  causes_->end();
  causes_->ask({.pins = {5}}, now_);
  causes_->follow(true);
  ASSERT_FALSE(causes_->open_bytes().empty());
  for (const CauseStep& step : causes_->steps()) EXPECT_NE(step.where.line, 4);

  avr_->restore(beginning);
  now_ = 0;
  causes_->begin();
  run(10 * kMillisecond);
  causes_->end();
  causes_->follow(false);
  const auto lines = by_line();
  ASSERT_THAT(lines, AllOf(Contains(Key(4)), Contains(Key(7))));
  EXPECT_EQ(lines.at(4).pin, kA2);
}

// A value stays unchanged because a branch skips the code that would change it. The skipped assignment may be
// in a function that this code calls.
TEST_F(CausesTest, LeadToTheBranchThatLeftAValueAsItWas) {
  const auto lines = lines_behind_pin_5(3.0, R"(int speed = 90, lost;
volatile int dark;
__attribute__((noinline)) void slow() { speed = 20; }
__attribute__((noinline)) void lose() { lost = lost + 1; }
void setup() {
  pinMode(5, OUTPUT);
}
void loop() {
  int seen = analogRead(A2);
  if (seen > 1000) {
    for (byte i = 0; i < 8; i++) dark = dark + i * seen;
    slow();
  }
  if (seen > 1010)
    lose();
  analogWrite(5, speed + lost / 1024 * 0);
  delay(1);
})");
  ASSERT_TRUE(lines.contains(10));
  EXPECT_EQ(lines.at(10).kind, CauseStep::Kind::decides);
  EXPECT_FALSE(lines.contains(14)) << "a skipped line on which the pin does not depend";
}

TEST_F(CausesTest, LeadToTheBranchThatLeftAMemberAsItWas) {
  const auto lines = lines_behind_pin_5(3.0, R"(struct Motor {
  volatile byte looked;
  int power;
  __attribute__((noinline)) void look(int seen) {
    looked = 1;
    if (seen > 1000)
      power = seen / 8;
  }
} motors[2];
volatile byte one = 1;
void setup() {
  pinMode(5, OUTPUT);
}
void loop() {
  motors[one].look(analogRead(A2));
  motors[0].look(analogRead(A2));
  analogWrite(5, motors[one].power);
  delay(1);
})");
  EXPECT_TRUE(lines.contains(6));
  ASSERT_TRUE(lines.contains(3)) << "the variable keeps its initial value";
  EXPECT_EQ(lines.at(3).kind, CauseStep::Kind::keeps);
}

TEST_F(CausesTest, OfAPlaceAreTheBranchesThatLedThere) {
  start(R"(void setup() {
  pinMode(4, INPUT_PULLUP);
}
void loop() {
  while (digitalRead(4) == HIGH) {
  }
  digitalWrite(13, HIGH);
})");
  run(5 * kMillisecond);
  causes_->begin();
  run(5 * kMillisecond);
  causes_->end();
  causes_->ask_place(now_);
  causes_->follow(true);
  const auto lines = by_line();
  EXPECT_FALSE(lines.contains(7));
  ASSERT_TRUE(lines.contains(5));
  EXPECT_EQ(lines.at(5).pin, 4);
}

TEST_F(CausesTest, NotingThemChangesNothing) {
  start(kSketch);
  run(20 * kMillisecond);
  const std::vector<SimTime> plain = changes(5);
  start(kSketch);
  run(3 * kMillisecond);
  causes_->begin();
  run(5 * kMillisecond);
  causes_->end();
  run(12 * kMillisecond);
  EXPECT_EQ(changes(5), plain);
}

}  // namespace robosim::exec::causes_test
