// Tests the fast walks of robots without a watcher. They must equal the walks of robots that call a watcher
// after each move.
#include "sim/map/cells/quick.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "sim/base/noise.h"
#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"
#include "sim/map/generator.h"
#include "tests/support/effort.h"

namespace robosim::cells {
namespace quick_test {

using map::Cell;
using map::CellAt;
using map::Direction;

/// A watcher that does nothing when a walk calls it.
class Asks final : public MoveWatcher {
 public:
  void moved(const CellPose&, Sense, Move, double) override {}
};

/// A sequence of random numbers.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : stream_(seed, 0, "dice", "quick") {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(stream_.bits(next_++) % n); }

 private:
  NoiseStream stream_;
  std::uint64_t next_ = 0;
};

// Returns a map of random cells of all kinds. The line cells seldom form lines.
map::Map jumble(Dice& dice) {
  map::Map map;
  map.width = 2 + static_cast<int>(dice.below(9));
  map.height = 1 + static_cast<int>(dice.below(9));
  const std::size_t lines = 2 + dice.below(8);
  for (int i = 0; i < map.width * map.height; ++i)
    map.cells.push_back(dice.below(10) < lines ? Cell::line : static_cast<Cell>(dice.below(5)));
  return map;
}

// Returns a generated map with some changed cells.
map::Map damaged(Dice& dice) {
  constexpr map::Family kFamilies[] = {map::Family::tree, map::Family::cycles, map::Family::grid};
  map::Map map =
      map::generate(kFamilies[dice.below(3)], 3 + static_cast<int>(dice.below(30)), dice.below(1000));
  for (std::size_t n = dice.below(12); n > 0; --n)
    map.cells[dice.below(map.cells.size())] = static_cast<Cell>(dice.below(5));
  return map;
}

std::optional<CellPose> somewhere(const map::Map& map, Dice& dice) {
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

std::string text(const Scan& scan) {
  std::string all = std::to_string(static_cast<int>(scan.ending)) + " " + std::to_string(scan.moves) + " " +
                    text(scan.end) + "\n";
  const auto add = [&](const map::Arm& arm) {
    all += " " + std::to_string(static_cast<int>(arm.out)) + ":" +
           std::to_string(static_cast<int>(arm.behind)) + ":" + std::to_string(arm.id) + ":" +
           std::to_string(arm.slot) + ":" + std::to_string(arm.length) + ":" +
           text({arm.obstacle, Direction::east});
  };
  for (const map::GraphStation& station : scan.graph.stations) {
    all += text({station.cell, Direction::north});
    add(station.arm);
    all += "\n";
  }
  for (const map::GraphJunction& junction : scan.graph.junctions) {
    all += text({junction.cell, Direction::south});
    for (const map::Arm& arm : junction.arms) add(arm);
    all += "\n";
  }
  return all;
}

TEST(Quick, ManyMovesOfAWalkLeadWhereTheyLeadOneByOne) {
  for (std::uint64_t n = 0; n < test::rounds(6000u); ++n) {
    Dice dice(n);
    const map::Map map = n % 2 == 0 ? jumble(dice) : damaged(dice);
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
    const map::Map map = n % 2 == 0 ? jumble(dice) : damaged(dice);
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

TEST(Quick, AScanAndDrivesEndAsWatchedOnes) {
  int complete = 0, arrived = 0;
  for (std::uint64_t n = 0; n < test::rounds(2000u); ++n) {
    Dice dice(n + 200'000);
    const map::Map map = n % 4 == 0 ? jumble(dice) : damaged(dice);
    const std::optional<CellPose> start = somewhere(map, dice);
    if (!start) continue;
    const CellFloor floor(map);
    CellRobot watched(floor, *start), quick(floor, *start);
    Asks asks;
    watched.watch(&asks);
    const std::uint64_t limit = n % 5 == 0 ? dice.below(400) : 100'000;
    watched.limit_moves(limit);
    quick.limit_moves(limit);
    Survey slow(watched), fast(quick);
    const Scan expected = slow.scan();
    complete += expected.ending == Ending::complete;
    ASSERT_EQ(text(fast.scan()), text(expected)) << n << " from " << text(*start);
    for (int drive = 0; drive < 4 && slow.here() != 0 && slow.stations() > 0; ++drive) {
      const int to = 1 + static_cast<int>(dice.below(static_cast<std::size_t>(slow.stations())));
      const Route way = slow.drive(to, slow.default_planner()), same = fast.drive(to, fast.default_planner());
      arrived += way.ending == Ending::complete;
      ASSERT_EQ(same.ending, way.ending) << n;
      ASSERT_EQ(same.turns, way.turns) << n;
      ASSERT_EQ(same.time, way.time) << n;
      ASSERT_EQ(text(same.end), text(way.end)) << n;
      ASSERT_EQ(fast.here(), slow.here()) << n;
    }
  }
  EXPECT_GT(complete, test::rounds(500));
  EXPECT_GT(arrived, test::rounds(500));
}

// Scans one long line with a dead end at every second cell. The route back has more lines than a CellWalker
// can record.
TEST(Quick, AScanDeeperThanTheWalkersMemoryEndsAsAWatchedOne) {
  constexpr int kWidth = 1001, kRows = test::rounds(150);
  map::Map map;
  map.width = kWidth;
  map.height = 4 * kRows;
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), Cell::floor);
  const auto draw = [&](int x, int y) { map.cells[map.index_of({x, y})] = Cell::line; };
  for (int row = 0; row < kRows; ++row) {
    const int y = 4 * row;
    for (int x = 0; x < kWidth; ++x) draw(x, y);
    for (int x = 2; x + 2 < kWidth; x += 2) draw(x, y + 1);
    for (int i = 1; i < 4 && row + 1 < kRows; ++i) draw(row % 2 == 0 ? kWidth - 1 : 0, y + i);
  }
  const CellFloor floor(map);
  const CellPose start{{0, 0}, Direction::east};
  CellRobot watched(floor, start), quick(floor, start);
  Asks asks;
  watched.watch(&asks);
  Survey slow(watched), fast(quick);
  const Scan& expected = slow.scan();
  EXPECT_EQ(expected.ending, Ending::complete);
  EXPECT_GT(expected.graph.junctions.size(), test::rounds(70'000u));
  const Scan& scan = fast.scan();
  EXPECT_EQ(map::difference(expected.graph, scan.graph), "");
  EXPECT_EQ(scan.moves, expected.moves);
  EXPECT_EQ(text(scan.end), text(expected.end));
}

}  // namespace quick_test
}  // namespace robosim::cells
