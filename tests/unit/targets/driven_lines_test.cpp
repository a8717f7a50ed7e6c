// Tests that the executor of a chip finds the sketch's line that has changed how a pin is driven.
#include <algorithm>
#include <map>
#include <set>

#include "tests/unit/targets/fixture.h"

namespace robosim::exec::driven_lines_test {

using testing::Each;
using testing::ElementsAre;

class DrivenLines : public TargetTest {
 protected:
  void before_power_on() override {
    lines_.clear();
    EXPECT_TRUE(executor_->chip_access()->trace_drives());
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    if (t == 0) return;
    const SourceLine& line = executor_->chip_access()->driving(pin, drive);
    lines_[pin].push_back(line.line);
    files_.insert(line.file);
  }
  /// Returns the lines that drove the pin, in order. Merges equal lines that directly follow each other.
  std::vector<int> distinct(const char* name) {
    std::vector<int> lines = lines_[pin(name)];
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
  }

  std::map<Pin, std::vector<int>> lines_;  // source lines; 0 = unknown
  std::set<std::string> files_;
};
class DrivenLinesOfAvr : public DrivenLines {};
INSTANTIATE_TEST_SUITE_P(, DrivenLines, testing::ValuesIn(targets({"avr", "stm32"})), name_of);
INSTANTIATE_TEST_SUITE_P(, DrivenLinesOfAvr, testing::ValuesIn(targets({"avr"})), name_of);

TEST_P(DrivenLines, AreThoseOfTheSketchThatCallTheCore) {
  start(R"(void light(bool on) {
  digitalWrite(13, on);
  delay(1);
}
void setup() {
  pinMode(13, OUTPUT);
  light(true);
  light(false);
  pinMode(7, INPUT_PULLUP);
}
void loop() {})");
  run(5 * kMillisecond);
  EXPECT_THAT(lines_[pin("13")], ElementsAre(6, 2, 2));
  EXPECT_THAT(lines_[pin("7")], ElementsAre(9));
  EXPECT_THAT(files_, ElementsAre("Test.ino"));
}

TEST_P(DrivenLines, AreThoseOfAFunctionThatEndsWithAJumpIntoTheCore) {
  start(R"(void __attribute__((noinline)) light(bool on) {
  digitalWrite(13, on);
}
void setup() {
  pinMode(13, OUTPUT);
  light(true);
  light(false);
}
void loop() {})");
  run(5 * kMillisecond);
  EXPECT_THAT(lines_[pin("13")], ElementsAre(5, 2, 2));
}

// A new duty cycle takes effect at the end of a PWM period, up to 2 ms after the analogWrite(). By that time,
// the sketch executes another line.
TEST_P(DrivenLines, AreThoseThatWroteADutyWhichIsTakenOverLater) {
  start(R"(void setup() {
  analogWrite(9, 50);
  analogWrite(10, 60);
  delay(5);
  analogWrite(9, 70);
  analogWrite(10, 80);
  delay(5);
  analogWrite(9, 0);
}
void loop() {
  delay(1);
})");
  run(15 * kMillisecond);
  EXPECT_THAT(distinct("9"), ElementsAre(2, 5, 8));
  EXPECT_THAT(distinct("10"), ElementsAre(3, 6));
}

TEST_P(DrivenLines, AreThoseOfAHandlerOfTheSketchAndNotOfWhatItInterrupts) {
  start(R"(#ifdef __AVR__  // on an AVR, the line of a digitalWrite() in a handler is unknown
#define TURN PINB = _BV(5)
#else
#define TURN digitalWrite(13, n & 1)
#endif
volatile long n;
void __attribute__((noinline)) count() { ++n; }
void turn() {
  TURN;
}
void setup() {
  pinMode(13, OUTPUT);
  pinMode(2, INPUT);
  attachInterrupt(digitalPinToInterrupt(2), turn, CHANGE);
  tone(8, 1000);
}
void loop() { count(); })");
  run(5 * kMillisecond);
  lines_.clear();
  for (int i = 0; i < 40; ++i) board().schedule_edge(pin("2"), i % 2 == 0, (6 + i) * kMillisecond);
  run(50 * kMillisecond);
  EXPECT_THAT(lines_[pin("13")], testing::SizeIs(testing::Gt(3)));
  EXPECT_THAT(lines_[pin("13")], Each(9));
  EXPECT_THAT(lines_[pin("8")], testing::SizeIs(testing::Gt(50)));
  EXPECT_THAT(lines_[pin("8")], Each(0)) << "the core's handler drives the pin";
}

TEST_P(DrivenLinesOfAvr, AreThoseThatWriteToPorts) {
  start(R"(volatile byte pattern = _BV(5) | _BV(4);
void setup() {
  DDRB |= _BV(5);
  PORTB |= _BV(5);
  PINB = _BV(5);
  PINB |= _BV(5);
  PORTB = pattern;
  PORTB &= ~_BV(5);
}
void loop() {})");
  run(2 * kMillisecond);
  EXPECT_THAT(lines_[13], ElementsAre(3, 4, 5, 6, 8));
}

TEST_P(DrivenLinesOfAvr, AreUnknownWhereTheCoresHandlersOrATimerDrive) {
  start(R"(void setup() {
  tone(8, 1000);
  pinMode(9, OUTPUT);
  TCCR1A = _BV(COM1A0);
  TCCR1B = _BV(WGM12) | _BV(CS12) | _BV(CS10);
  OCR1A = 1000;
}
void other() { delay(1); }
void loop() { other(); })");
  run(300 * kMillisecond);  // below 20 Hz, the executor reports each compare match
  ASSERT_GT(lines_[8].size(), 20u);
  const auto known = [](int line) { return line > 0; };
  EXPECT_EQ(std::count_if(lines_[8].begin() + 1, lines_[8].end(), known), 0)
      << "timer 2's handler toggles the pin";
  ASSERT_GT(lines_[9].size(), 3u);
  for (const int line : lines_[9]) EXPECT_LE(line, 6) << "the line is not in loop()";
  EXPECT_EQ(lines_[9].back(), 0);
}

}  // namespace robosim::exec::driven_lines_test
