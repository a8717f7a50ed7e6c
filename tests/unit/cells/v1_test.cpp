// Compares the simulation of a robot on cells, move for move, with a simple re-implementation of Robosim v1.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/base/noise.h"
#include "sim/map/cells/survey.h"
#include "sim/map/cells/walk.h"
#include "sim/map/generator.h"
#include "tests/support/effort.h"
#include "tests/support/v1.h"

namespace robosim::cells {
namespace v1_test {

using map::Cell;
using map::CellAt;

class Tape final : public MoveWatcher {
 public:
  void moved(const CellPose& pose, Sense sense, Move move, double clock) override {
    moves.push_back(std::to_string(pose.cell.x) + "," + std::to_string(pose.cell.y) + "," +
                    letter(pose.facing) + "," + name_of(sense) + "," + name_of(move) + "," +
                    std::to_string(static_cast<long>(clock)));
  }
  std::vector<std::string> moves;
};

// Returns a map whose lines form a tree. If `walls` is true, some dead ends touch a wall.
map::Map tree(int stations, std::uint64_t seed, bool walls) {
  map::Map map = map::generate(map::Family::tree, stations, seed);
  if (!walls) return map;
  const NoiseStream chance(seed, 0, "walls", "test");
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const CellAt cell = map.cell_at(i);
    if (map.cells[i] != Cell::line || !std::has_single_bit(map::line_neighbours(map, cell))) continue;
    const auto along = static_cast<map::Direction>(std::countr_zero(map::line_neighbours(map, cell)));
    const CellAt next = ahead(cell, reversed(along)), beyond = ahead(next, reversed(along));
    if (map.contains(next) && map.at(next) == Cell::floor && map.at(beyond) != Cell::line &&
        chance.bits(n++) % 3 == 0)
      map.cells[map.index_of(next)] = Cell::wall;
  }
  return map;
}

TEST(AgainstV1, ScansAreTheSameMoveForMoveAndGraphsTheSameSlotForSlot) {
  for (int n = 0; n < 300; ++n) {
    const map::Map map = tree(3 + n % 40, 1000 + static_cast<std::uint64_t>(n), n % 2 == 1);
    const map::Start start = map::default_start(map);
    std::vector<std::string> expected;
    v1::Robot reference{&map, start.cell.x, start.cell.y, letter(start.facing), 0, &expected};
    const v1::Scan graph = v1::scan(reference);

    const CellFloor floor(map);
    CellRobot robot(floor, {start.cell, start.facing});
    Tape tape;
    robot.watch(&tape);
    Survey survey(robot);
    const Scan& scan = survey.scan();

    ASSERT_EQ(scan.ending, Ending::complete) << map.name;
    ASSERT_EQ(tape.moves, expected) << map.name;
    EXPECT_EQ(scan.time, static_cast<double>(reference.clock)) << map.name;
    EXPECT_EQ(scan.end, (CellPose{{reference.x, reference.y}, robot.facing()})) << map.name;
    ASSERT_EQ(scan.graph.stations.size(), static_cast<std::size_t>(graph.stations)) << map.name;
    ASSERT_EQ(scan.graph.junctions.size() + 1, graph.nodes.size()) << map.name;
    for (std::size_t j = 1; j < graph.nodes.size(); ++j) {
      for (std::size_t slot = 0; slot < 3; ++slot) {
        const map::Arm& arm = scan.graph.junctions[j - 1].arms[slot];
        const bool station = arm.behind == map::Arm::Behind::station;
        EXPECT_EQ(station ? arm.id : 0, graph.nodes[j].station[slot]) << map.name << ", node " << j;
        EXPECT_EQ(station ? 0 : arm.id, graph.nodes[j].junction[slot]) << map.name << ", node " << j;
      }
    }
  }
}

TEST(AgainstV1, TheLeftAndRightWalksAreTheSameMoveForMove) {
  for (int n = 0; n < test::rounds(100); ++n) {
    const map::Map map = tree(2 + n % 30, 5000 + static_cast<std::uint64_t>(n), n % 2 == 1);
    const map::Start start = map::default_start(map);
    for (const bool left : {true, false}) {
      std::vector<std::string> expected;
      v1::Robot reference{&map, start.cell.x, start.cell.y, letter(start.facing), 0, &expected};
      const CellFloor floor(map);
      CellRobot robot(floor, {start.cell, start.facing});
      Tape tape;
      robot.watch(&tape);
      for (int move = 0; move < 2000; ++move) {
        const std::string sense = reference.sense();
        if (sense == "straight") reference.step_forward();
        if (sense == "right_turn") reference.turn_right();
        if (sense == "left_turn") reference.turn_left();
        if (sense == "no_path") reference.turn_around();
        if (sense == "junction") left ? reference.choose_left() : reference.choose_right();
        walk_on(robot, left ? Side::left : Side::right);
      }
      ASSERT_EQ(tape.moves, expected) << map.name;
    }
  }
}

}  // namespace v1_test
}  // namespace robosim::cells
