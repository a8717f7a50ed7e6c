#include "sim/classic/walk.h"

#include <unordered_set>

namespace robosim::classic {

Walk walk(CellRobot& robot, Side side) {
  Walk walk;
  const CellFloor& floor = robot.floor();
  std::unordered_set<std::size_t> seen;
  std::size_t at = floor.map().cells.size();  // no cell yet
  // Brent's way of noticing a round: the pose to come back to is moved on to ever later moves.
  CellPose mark = robot.pose();
  std::uint64_t next_mark = robot.moves() + 1;
  const CellPose start = mark;
  try {
    do {
      if (robot.at() != at && floor.is_open(robot.at())) {
        at = robot.at();
        const grid::CellAt cell = floor.cell_at(at);
        if (grid::is_dead_end(floor.map(), cell) && seen.insert(at).second) walk.dead_ends.push_back(cell);
      }
      if (robot.moves() >= next_mark) {
        mark = robot.pose();
        next_mark *= 2;
      }
      walk_on(robot, side);
    } while (robot.pose() != mark && robot.pose() != start);
    walk.closed = true;
  } catch (const OutOfMoves&) {
  }
  walk.moves = robot.moves();
  walk.time = robot.clock();
  walk.end = robot.pose();
  return walk;
}

}  // namespace robosim::classic
