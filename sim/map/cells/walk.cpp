#include "sim/map/cells/walk.h"

#include <algorithm>

namespace robosim::cells {

void DeadEnds::look(const CellRobot& robot) {
  if (robot.at() == at_) return;
  at_ = robot.at();
  const CellFloor& floor = robot.floor();
  if (!floor.is_open(at_)) return;
  const map::CellAt cell = floor.cell_at(at_);
  if (map::is_dead_end(floor.map(), cell) && seen_.insert(at_).second) cells_.push_back(cell);
}

void walk_on(CellRobot& robot, Side side, std::uint64_t moves) {
  while (moves > 0) {
    Spot spot = robot.spot();
    const std::uint64_t made = keep_to(side, robot.floor(), spot, std::min(moves, robot.free_moves()));
    robot.made(made, spot);
    moves -= made;
    if (moves == 0) break;
    walk_on(robot, side);
    --moves;
  }
}

Walk walk(CellRobot& robot, Side side) {
  Walk walk;
  DeadEnds visited;
  // Uses Brent's cycle detection: after 1, 2, 4, … moves, marks the robot's current spot.
  Spot mark = robot.spot();
  std::uint64_t next_mark = robot.moves() + 1;
  const Spot start = mark;
  try {
    do {
      visited.look(robot);
      if (robot.moves() >= next_mark) {
        mark = robot.spot();
        next_mark *= 2;
      }
      Spot spot = robot.spot();
      const std::uint64_t most = std::min(next_mark - robot.moves(), robot.free_moves());
      const std::uint64_t made = keep_to(side, robot.floor(), spot, most, mark, start);
      robot.made(made, spot);
      if (made == 0) walk_on(robot, side);
    } while (robot.spot() != mark && robot.spot() != start);
    walk.ending = Walk::Ending::closed;
  } catch (const OutOfMoves&) {
  }
  walk.moves = robot.moves();
  walk.time = robot.clock();
  walk.end = robot.pose();
  walk.dead_ends = visited.cells();
  return walk;
}

}  // namespace robosim::cells
