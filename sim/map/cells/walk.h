// Implements the first two algorithms of `robosim classic`: walks that keep to the left or to the right. On a
// tree, both visit everything and return to the start.
#pragma once

#include <unordered_set>
#include <vector>

#include "sim/map/cells/cell_robot.h"
#include "sim/map/cells/quick.h"

namespace robosim::cells {

/// Makes one move of the walk.
inline void walk_on(CellRobot& robot, Side side) {
  switch (robot.sense()) {
    case Sense::straight:
      return robot.step_forward();
    case Sense::right_turn:
      return robot.turn_right();
    case Sense::left_turn:
      return robot.turn_left();
    case Sense::no_path:
      return robot.turn_around();
    case Sense::junction:
      return side == Side::left ? robot.choose_left() : robot.choose_right();
  }
}
/// Makes `moves` moves of the walk.
void walk_on(CellRobot& robot, Side side, std::uint64_t moves);

struct Walk {
  enum class Ending {
    closed,        ///< the walk would repeat
    out_of_moves,  ///< the limit of moves is reached
    returned       ///< a user's algorithm has ended
  };
  Ending ending = Ending::out_of_moves;
  std::uint64_t moves = 0;
  double time = 0.0;  ///< seconds, by the robot's clock
  CellPose end;
  std::vector<map::CellAt> dead_ends;  ///< in the order of the first visit
};

/// The line ends that a robot has reached, in the order of the first visit.
class DeadEnds {
 public:
  /// Records the robot's place. Call this after every move.
  void look(const CellRobot& robot);
  const std::vector<map::CellAt>& cells() const { return cells_; }

 private:
  std::size_t at_ = 0;  // the cell at the last call; 0 is off the map
  std::unordered_set<std::size_t> seen_;
  std::vector<map::CellAt> cells_;
};

/// Walks until the robot is back in its initial pose, a repetition is detected, or the moves are used up. A
/// robot that starts outside the loop of its walk never returns to its initial pose, but repeats the loop.
/// Robosim v1 does not detect repetitions, so such a walk never ends in v1.
Walk walk(CellRobot& robot, Side side);

}  // namespace robosim::cells
