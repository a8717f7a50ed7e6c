// Tests that the executor finds the line of the sketch that has changed the drive of a pin.
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "tests/unit/exec_stm32/chip_fixture.h"

namespace robosim::exec {
namespace driven_lines_test {

using testing::ElementsAre;

class Stm32DrivenLinesTest : public Stm32ChipTest, PinWatcher {
 protected:
  void before_power_on() override {
    lines_.clear();
    EXPECT_TRUE(chip_->trace_drives());
    for (Pin pin = 0; pin < chip_->board().spec().pin_count; ++pin) chip_->board().watch(pin, *this);
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    if (t == 0) return;
    lines_[chip_->board().spec().pins[pin].name].push_back(chip_->driving(pin, drive).line);
  }

  std::map<std::string, std::vector<int>> lines_;  // source lines; 0 = unknown
};

TEST_F(Stm32DrivenLinesTest, AreThoseOfTheSketchThatCallTheCore) {
  start(R"(void __attribute__((noinline)) light(bool on) {
  digitalWrite(13, on);
}
void setup() {
  pinMode(13, OUTPUT);
  light(true);
  light(false);
  pinMode(22, INPUT_PULLUP);
}
void loop() {})");
  run(5 * kMillisecond);
  EXPECT_THAT(lines_["D13"], ElementsAre(5, 2, 2)) << "light() ends with a jump into the core";
  EXPECT_THAT(lines_["D22"], ElementsAre(8));
}

// A new duty cycle takes effect at the timer's next update, up to 2 ms after the analogWrite(). By that time,
// the sketch executes another line.
TEST_F(Stm32DrivenLinesTest, AreThoseThatWroteADutyWhichIsTakenOverLater) {
  start(R"(void setup() {
  analogWrite(12, 50);
  analogWrite(11, 60);
  delay(5);
  analogWrite(12, 70);
  analogWrite(11, 80);
  delay(5);
  analogWrite(12, 0);
}
void loop() {
  delay(1);
})");
  run(15 * kMillisecond);
  const auto distinct = [&](const char* pin) {
    std::vector<int> lines = lines_[pin];
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
  };
  EXPECT_THAT(distinct("D12"), ElementsAre(2, 5, 8));
  EXPECT_THAT(distinct("D11"), ElementsAre(3, 6));
}

TEST_F(Stm32DrivenLinesTest, AreThoseOfAHandlerOfTheSketchAndNotOfWhatItInterrupts) {
  start(R"(volatile long n;
void __attribute__((noinline)) count() { ++n; }
void turn() {
  digitalWrite(13, n & 1);
}
void setup() {
  pinMode(13, OUTPUT);
  pinMode(2, INPUT);
  attachInterrupt(digitalPinToInterrupt(2), turn, CHANGE);
  tone(22, 1000);
}
void loop() { count(); })");
  run(5 * kMillisecond);
  lines_.clear();
  for (int i = 0; i < 40; ++i) chip_->board().schedule_edge(2, i % 2 == 0, (6 + i) * kMillisecond);
  run(50 * kMillisecond);
  ASSERT_GT(lines_["D13"].size(), 3u);
  EXPECT_EQ(std::set<int>(lines_["D13"].begin(), lines_["D13"].end()), std::set<int>{4});
  ASSERT_GT(lines_["D22"].size(), 50u);
  EXPECT_EQ(std::set<int>(lines_["D22"].begin(), lines_["D22"].end()), std::set<int>{0})
      << "the core's handler drives the pin";
}

}  // namespace driven_lines_test
}  // namespace robosim::exec
