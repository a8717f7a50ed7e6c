// Tests displays of text and colours, and the sensor of the motors' current.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace displays_test {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> told(BenchRobot& bench, int ticks) {
  std::vector<PartText> all;
  for (int i = 0; i < ticks; ++i) {
    bench.tick();
    bench.robot.poll_text(bench.now, all);
  }
  std::vector<std::string> texts;
  for (const PartText& one : all) texts.push_back(one.text);
  return texts;
}

constexpr Pin kRs = 12, kE = 11;

constexpr const char* kLcd =
    "[[part]]\nname = \"lcd\"\ntype = \"lcd\"\npins = { rs = 12, en = 11, d4 = 5, d5 = 4, d6 = 3, d7 = 2 }\n";

class Lcd {
 public:
  void nibble(unsigned bits) {
    for (int i = 0; i < 4; ++i) bench.board.output(static_cast<Pin>(5 - i), bits >> i & 1, t());
    bench.board.output(kE, true, t());
    us_ += 1;
    bench.board.output(kE, false, t());
  }
  void write(bool data, unsigned byte, SimTime wait_us = 100) {
    bench.board.output(kRs, data, t());
    nibble(byte >> 4);
    nibble(byte & 15);
    wait(wait_us);
  }
  void print(const std::string& text) {
    for (const char c : text) write(true, static_cast<unsigned char>(c));
  }
  void wait(SimTime us) {
    us_ += us;
    for (; us_ >= 1000; us_ -= 1000) bench.tick();
  }
  // Initialises the display with the sequence of figure 24 in the HD44780's data sheet. The library
  // LiquidCrystal uses the same sequence.
  void begin() {
    for (int i = 0; i < 3; ++i) {
      nibble(3);
      wait(4500);
    }
    nibble(2);
    wait(100);
    write(false, 0x28);
    write(false, 0x0C);
    write(false, 0x01, 2000);
    write(false, 0x06);
  }

  BenchRobot bench{kLcd};

 private:
  SimTime t() const { return bench.now + us_ * kMicrosecond; }
  SimTime us_ = 0;
};

TEST(LcdPart, TellsWhatItShowsWhenThatHasStayed) {
  Lcd lcd;
  lcd.begin();
  lcd.print("Hello, robot");
  EXPECT_THAT(told(lcd.bench, 40), IsEmpty());
  EXPECT_THAT(told(lcd.bench, 40), ElementsAre("Hello, robot"));
  lcd.write(false, 0x80 | 0x40);
  lcd.print("Lap 2");
  lcd.write(false, 0x80 | 7);
  lcd.print("world");
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre("Hello, world|Lap 2"));
  lcd.write(false, 0x80 | 7);
  lcd.print("world");
  EXPECT_THAT(told(lcd.bench, 80), IsEmpty()) << "repeated text is not reported";
  lcd.write(false, 0x08);
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre(" ")) << "the display is switched off";
}

TEST(LcdPart, ScrollsAndShowsItsWindow) {
  Lcd lcd;
  lcd.begin();
  lcd.print("0123456789ABCDEFGHIJ");
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre("0123456789ABCDEF"));
  lcd.write(false, 0x18);
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre("123456789ABCDEFG"));
  lcd.write(false, 0x02, 2000);
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre("0123456789ABCDEF"));
}

TEST(LcdPart, LosesWhatComesWhileItIsBusy) {
  Lcd lcd;
  lcd.begin();
  lcd.write(false, 0x01, 500);  // clearing takes 1.52 ms, but the sketch waits 0.5 ms
  lcd.print("ab");
  lcd.wait(2000);
  lcd.print("cd");
  EXPECT_THAT(told(lcd.bench, 80), ElementsAre("cd"));
}

constexpr const char* kStrip = "[[part]]\nname = \"strip\"\ntype = \"ws2812\"\npin = 6\nleds = 3\n";

// Sends the 24 bits `grb` (green, red, blue), the highest bit first. Returns the time after the last bit.
SimTime shift(BenchRobot& bench, SimTime t, std::uint32_t grb) {
  for (int bit = 23; bit >= 0; --bit) {
    bench.board.output(6, true, t);
    bench.board.output(6, false, t + ((grb >> bit & 1) ? 800 : 400));
    t += 1250;
  }
  return t;
}

TEST(Ws2812, ShowsTheColoursAfterAReset) {
  BenchRobot bench(kStrip);
  bench.board.output(6, false, bench.now);
  SimTime t = shift(bench, bench.now, 0x00FF00);
  shift(bench, t, 0x800000);
  EXPECT_THAT(told(bench, 60), ElementsAre("FF0000 008000 000000"));
  EXPECT_EQ(bench.robot.readings().at(0).value, 2.0);
  t = shift(bench, bench.now, 0x00FF00);
  shift(bench, t, 0x800000);
  EXPECT_THAT(told(bench, 60), IsEmpty()) << "repeated colours are not reported";
  t = bench.now;
  for (int i = 0; i < 4; ++i) t = shift(bench, t, 0x010203);
  EXPECT_THAT(told(bench, 60), ElementsAre("020103 020103 020103"))
      << "a fourth colour goes past the strip's end";
}

TEST(CurrentSensor, TellsWhatTheMotorsDraw) {
  BenchRobot bench(R"(
[[part]]
name = "left"
type = "motor"
pins = { en = 5, in1 = 7, in2 = 8 }
[[part]]
name = "right"
type = "motor"
pins = { en = 6, in1 = 9, in2 = 10 }
[[part]]
name = "amps"
type = "current-sensor"
pin = "A0"
)");
  bench.ticks(5);
  EXPECT_NEAR(bench.volts(14), 2.5, 1e-9);
  bench.robot.fault("left", "stuck", {});
  for (const Pin pin : {Pin{5}, Pin{7}}) bench.board.output(pin, true, bench.now);
  bench.ticks(5);
  const double stall = 6.0 / (6.0 / 1.6 + 0.5);  // supply / (winding + driver), in A
  EXPECT_NEAR(bench.volts(14), 2.5 + 0.185 * stall, 0.01);
  EXPECT_NEAR(bench.robot.readings().at(0).value, stall, 0.05);
}

}  // namespace displays_test
}  // namespace robosim::robot
