// Tests that the executor finds the line of the sketch that has changed the drive of a pin.
#include <map>
#include <set>

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace driven_lines_test {

using testing::ElementsAre;
using testing::IsEmpty;

class DrivenLinesTest : public AvrTest {
 protected:
  void before_power_on() override {
    lines_.clear();
    EXPECT_TRUE(avr_->trace_drives());
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    AvrTest::pin_changed(pin, drive, t);
    if (t == 0) return;
    const SourceLine& line = avr_->driving(pin, drive);
    lines_[pin].push_back(line.line);
    files_.insert(line.file);
  }

  std::map<Pin, std::vector<int>> lines_;  // source lines; 0 = unknown
  std::set<std::string> files_;
};

TEST_F(DrivenLinesTest, AreThoseOfTheSketchThatCallTheCore) {
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
  EXPECT_THAT(lines_[13], ElementsAre(6, 2, 2));
  EXPECT_THAT(lines_[7], ElementsAre(9));
  EXPECT_THAT(files_, ElementsAre("Test.ino"));
}

TEST_F(DrivenLinesTest, AreThoseThatWriteToPorts) {
  start(R"(volatile byte pattern = 0x30;
void setup() {
  DDRB |= 0x20;
  PORTB |= 0x20;
  PINB = 0x20;
  PINB |= 0x20;
  PORTB = pattern;
  PORTB &= ~0x20;
}
void loop() {})");
  run(2 * kMillisecond);
  EXPECT_THAT(lines_[13], ElementsAre(3, 4, 5, 6, 8));
}

// A new duty cycle takes effect at the end of a PWM period, up to 2 ms after the analogWrite(). By that time,
// the sketch executes another line.
TEST_F(DrivenLinesTest, AreThoseThatWroteADutyWhichIsTakenOverLater) {
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
  ASSERT_GE(lines_[9].size(), 3u);
  ASSERT_GE(lines_[10].size(), 2u);
  EXPECT_EQ(lines_[9].back(), 8) << "a low level takes effect immediately";
  lines_[9].pop_back();
  EXPECT_EQ(std::set<int>(lines_[9].begin(), lines_[9].end()), (std::set<int>{2, 5}));
  EXPECT_EQ(lines_[9].back(), 5);
  EXPECT_EQ(std::set<int>(lines_[10].begin(), lines_[10].end()), (std::set<int>{3, 6}));
  EXPECT_EQ(lines_[10].back(), 6);
}

TEST_F(DrivenLinesTest, AreUnknownWhereTheCoresHandlersOrATimerDrive) {
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

TEST_F(DrivenLinesTest, AreThoseOfAHandlerOfTheSketch) {
  start(R"(void turn() {
  PINB = 0x20;
}
void setup() {
  pinMode(13, OUTPUT);
  attachInterrupt(0, turn, RISING);
}
void loop() { delay(1); })");
  run(5 * kMillisecond);
  lines_.clear();
  board().schedule_edge(2, true, 6 * kMillisecond);
  run(5 * kMillisecond);
  EXPECT_THAT(lines_[13], ElementsAre(2));
}

}  // namespace driven_lines_test
}  // namespace robosim::exec
