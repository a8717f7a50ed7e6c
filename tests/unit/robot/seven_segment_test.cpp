// Tests seven-segment displays.
#include <gtest/gtest.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace seven_segment_test {

std::string digit(const std::string& common) {
  return "[[part]]\nname = \"digit\"\ntype = \"seven-segment\"\ncommon = \"" + common +
         "\"\npins = { a = 2, b = 3, c = 4, d = 5, e = 6, f = 7, g = 8 }\n";
}

double shown(BenchRobot& bench) { return bench.robot.readings()[0].value; }

// Drives the segments a to g, which are on pins 2 to 8. Bit 0 of `high` is segment a.
void drive(BenchRobot& bench, unsigned high) {
  for (unsigned i = 0; i < 7; ++i) bench.board.output(static_cast<Pin>(2 + i), (high >> i & 1) != 0, 0);
}

TEST(SevenSegment, ReadsTheTenFiguresDarknessAndAnythingElse) {
  constexpr unsigned kFigures[] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};
  BenchRobot bench(digit("cathode"));
  for (int figure = 0; figure < 10; ++figure) {
    drive(bench, kFigures[figure]);
    EXPECT_EQ(shown(bench), figure);
  }
  drive(bench, 0);
  EXPECT_EQ(shown(bench), -1);
  drive(bench, 0x40);
  EXPECT_EQ(shown(bench), -2);
}

TEST(SevenSegment, WithACommonAnodeALowPinLights) {
  BenchRobot bench(digit("anode"));
  EXPECT_EQ(shown(bench), -1) << "no segment is driven yet";
  drive(bench, 0x7F & ~0x5Bu);
  EXPECT_EQ(shown(bench), 2);
}

TEST(SevenSegment, OfThePonyShowsThePapersCodes) {
  constexpr unsigned kCodes[] = {0x02, 0x4F, 0x24, 0x05, 0x49, 0x11, 0x10, 0x47, 0x00, 0x41};
  BenchRobot bench(load_description("pony"));
  for (const Pin pin : {10, 11, 13}) bench.board.output(pin, false, 0);
  for (int figure = 0; figure < 10; ++figure) {
    const unsigned bytes = kCodes[9 - figure] << 16 | kCodes[figure] << 8;  // for REG3, REG2, REG1
    for (int bit = 23; bit >= 0; --bit) {
      bench.board.output(11, (bytes >> bit & 1) != 0, 0);
      bench.board.output(13, true, 0);
      bench.board.output(13, false, 0);
    }
    bench.board.output(10, true, 0);
    bench.board.output(10, false, 0);
    for (const Reading& reading : bench.robot.readings()) {
      if (reading.part == "ones") {
        EXPECT_EQ(reading.value, figure);
      } else if (reading.part == "tens") {
        EXPECT_EQ(reading.value, 9 - figure);
      }
    }
  }
}

}  // namespace seven_segment_test
}  // namespace robosim::robot
