#include "sim/cells/walk.h"

namespace robosim::cells {

void DeadEnds::look(const CellRobot& robot) {
  if (robot.at() == at_) return;
  at_ = robot.at();
  const CellFloor& floor = robot.floor();
  if (!floor.is_open(at_)) return;
  const grid::CellAt cell = floor.cell_at(at_);
  if (grid::is_dead_end(floor.map(), cell) && seen_.insert(at_).second) cells_.push_back(cell);
}

Walk walk(CellRobot& robot, Side side) {
  Walk walk;
  DeadEnds visited;
  // Brent's way of noticing a round: the pose to come back to is moved on to ever later moves.
  CellPose mark = robot.pose();
  std::uint64_t next_mark = robot.moves() + 1;
  const CellPose start = mark;
  try {
    do {
      visited.look(robot);
      if (robot.moves() >= next_mark) {
        mark = robot.pose();
        next_mark *= 2;
      }
      walk_on(robot, side);
    } while (robot.pose() != mark && robot.pose() != start);
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
