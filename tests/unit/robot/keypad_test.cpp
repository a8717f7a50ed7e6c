// Tests keypads whose keys join rows and columns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace keypad_test {

using testing::HasSubstr;

constexpr const char* kPad =
    "[[part]]\nname = \"pad\"\ntype = \"keypad\"\nrows = [2, 3, 4, 5]\ncolumns = [6, 7, 8]\n";

// Scans the keypad as the Keypad library does: enables pull-ups on the rows, and drives the columns low one
// after another. Returns the pressed keys.
std::string scan(BenchRobot& bench) {
  const std::vector<std::string> keys{"123", "456", "789", "*0#"};
  std::string found;
  for (Pin row = 2; row <= 5; ++row) bench.board.input(row, true, bench.now);
  for (Pin column = 6; column <= 8; ++column) {
    bench.board.output(column, false, bench.now);
    for (Pin row = 2; row <= 5; ++row)
      if (!bench.level(row)) found += keys[row - 2][column - 6];
    bench.board.input(column, false, bench.now);
  }
  return found;
}

TEST(Keypad, JoinsTheRowAndTheColumnOfAPressedKey) {
  BenchRobot bench(kPad);
  EXPECT_EQ(scan(bench), "");
  for (const char key : std::string("1234567890*#")) {
    const std::string name = std::string("pad.") + key;
    bench.robot.press(name, bench.now);
    EXPECT_EQ(scan(bench), std::string(1, key));
    bench.robot.release(name, bench.now);
    EXPECT_EQ(scan(bench), "");
  }
}

TEST(Keypad, ShowsAFourthKeyWhereThreeAreOnCornersOfARectangle) {
  BenchRobot bench(kPad);
  for (const char* key : {"pad.1", "pad.2", "pad.4"}) bench.robot.press(key, bench.now);
  EXPECT_EQ(scan(bench), "1425");
}

TEST(Keypad, WakesAnInterruptOnARow) {
  BenchRobot bench(kPad);
  bench.board.input(2, true, bench.now);
  bench.board.output(6, false, bench.now);
  bench.board.want_edges(2, bench.now);
  bench.robot.press("pad.1", bench.now);
  ASSERT_EQ(bench.board.edges.size(), 1u);
  EXPECT_FALSE(bench.board.edges[0].level);
}

TEST(Keypad, NamesItsKeys) {
  BenchRobot bench(kPad);
  EXPECT_NO_THROW(bench.robot.check_press("pad.#"));
  EXPECT_THROW(bench.robot.check_press("pad.A"), InputError);
  try {
    BenchRobot wrong(std::string(kPad) + "keys = [\"12\", \"34\"]\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("for these pins, 4 strings of 3 characters"));
  }
}

}  // namespace keypad_test
}  // namespace robosim::robot
