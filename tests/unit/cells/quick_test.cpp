// What is quick while nobody asks after each move does the same as the robot does move by move.
#include "sim/cells/quick.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "sim/base/noise.h"
#include "sim/cells/walk.h"
#include "sim/grid/generator.h"
#include "tests/support/effort.h"

namespace robosim::cells {
namespace {

using grid::Cell;
using grid::CellAt;
using grid::Direction;

/// Asks after each move, and wants nothing.
class Asks final : public MoveWatcher {
 public:
  void moved(const CellPose&, Sense, Move, double) override {}
};

/// A sequence of numbers by chance.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : stream_(seed, 0, "dice", "quick") {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(stream_.bits(next_++) % n); }

 private:
  NoiseStream stream_;
  std::uint64_t next_ = 0;
};

// Cells of all kinds without any order: what no map of lines looks like.
grid::Map jumble(Dice& dice) {
  grid::Map map;
  map.width = 2 + static_cast<int>(dice.below(9));
  map.height = 1 + static_cast<int>(dice.below(9));
  const std::size_t lines = 2 + dice.below(8);
  for (int i = 0; i < map.width * map.height; ++i)
    map.cells.push_back(dice.below(10) < lines ? Cell::line : static_cast<Cell>(dice.below(5)));
  return map;
}

// Lines by a generator, with some cells that were changed.
grid::Map damaged(Dice& dice) {
  constexpr grid::Family kFamilies[] = {grid::Family::tree, grid::Family::cycles, grid::Family::grid};
  grid::Map map =
      grid::generate(kFamilies[dice.below(3)], 3 + static_cast<int>(dice.below(30)), dice.below(1000));
  for (std::size_t n = dice.below(12); n > 0; --n)
    map.cells[dice.below(map.cells.size())] = static_cast<Cell>(dice.below(5));
  return map;
}

std::optional<CellPose> somewhere(const grid::Map& map, Dice& dice) {
  std::vector<CellAt> open;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (map.cells[i] == Cell::line || map.cells[i] == Cell::gap) open.push_back(map.cell_at(i));
  if (open.empty()) return std::nullopt;
  return CellPose{open[dice.below(open.size())], static_cast<Direction>(dice.below(4))};
}

std::string text(const CellPose& pose) {
  return std::to_string(pose.cell.x) + "," + std::to_string(pose.cell.y) + "," + letter(pose.facing);
}

std::string text(const Walk& walk) {
  std::string all = std::to_string(static_cast<int>(walk.ending)) + " " + std::to_string(walk.moves) + " " +
                    std::to_string(walk.time) + " " + text(walk.end);
  for (const CellAt cell : walk.dead_ends) all += " " + text({cell, Direction::east});
  return all;
}

TEST(Quick, ManyMovesOfAWalkLeadWhereTheyLeadOneByOne) {
  for (std::uint64_t n = 0; n < test::rounds(6000u); ++n) {
    Dice dice(n);
    const grid::Map map = n % 2 == 0 ? jumble(dice) : damaged(dice);
    const std::optional<CellPose> start = somewhere(map, dice);
    if (!start) continue;
    const CellFloor floor(map);
    CellRobot one(floor, *start), many(floor, *start);
    const Side side = dice.below(2) == 0 ? Side::left : Side::right;
    for (int part = 0; part < 8; ++part) {
      const std::uint64_t moves = dice.below(60);
      for (std::uint64_t i = 0; i < moves; ++i) walk_on(one, side);
      walk_on(many, side, moves);
      ASSERT_EQ(text(many.pose()), text(one.pose())) << n;
      ASSERT_EQ(many.moves(), one.moves()) << n;
    }
    const std::uint64_t limit = one.moves() + dice.below(20);
    one.limit_moves(limit);
    many.limit_moves(limit);
    while (one.moves() < limit) walk_on(one, side);
    EXPECT_THROW(walk_on(many, side, 20), OutOfMoves) << n;
    ASSERT_EQ(text(many.pose()), text(one.pose())) << n;
    ASSERT_EQ(many.moves(), limit) << n;
  }
}

TEST(Quick, AWalkEndsAsOneThatIsWatched) {
  int closed = 0;
  for (std::uint64_t n = 0; n < test::rounds(6000u); ++n) {
    Dice dice(n + 100'000);
    const grid::Map map = n % 2 == 0 ? jumble(dice) : damaged(dice);
    const std::optional<CellPose> start = somewhere(map, dice);
    if (!start) continue;
    const CellFloor floor(map);
    CellRobot watched(floor, *start, 0.5), quick(floor, *start, 0.5);
    Asks asks;
    watched.watch(&asks);
    const std::uint64_t limit = n % 3 == 0 ? dice.below(200) : 5000;
    watched.limit_moves(limit);
    quick.limit_moves(limit);
    const Side side = dice.below(2) == 0 ? Side::left : Side::right;
    const Walk slow = walk(watched, side);
    closed += slow.ending == Walk::Ending::closed;
    ASSERT_EQ(text(walk(quick, side)), text(slow)) << n << " from " << text(*start);
  }
  EXPECT_GT(closed, test::rounds(1000));
}

}  // namespace
}  // namespace robosim::cells
