// The robot on cells, as a Walker for the navigator (firmware/src/nav/Landmark.h).
//
// Its moves are v1's. At a junction the first way out to the right of the one it came by is choose_right, the
// last is choose_left, and the one between them is step_forward; the way back is turn_around and
// step_forward. Places are the map's cells. A grid has a compass: heading 0 is east, whichever way the robot
// faces when it begins.
//
// If an obstacle is right beside a junction, the robot sees it before it moves: it does not have to leave the
// junction to find it, and finding it costs no move.
#pragma once

#include "firmware/src/nav/Landmark.h"
#include "sim/cells/cell_robot.h"

namespace robosim::cells {

class CellWalker {
 public:
  static constexpr bool kKnowsPlaces = true;

  explicit CellWalker(CellRobot& robot) : robot_(robot) {}

  /// Known from the map, at no cost; but a robot at a line's end that faces away turns round, which is a
  /// move.
  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place&) {}
  /// The robot was put onto a line's end, facing along it.
  void reset();

  /// Of the last landmark: its cell, the moves before it, and, if it is `blocked`, where the obstacle stands.
  grid::CellAt cell() const { return cell_; }
  std::uint32_t cost() const { return cost_; }
  grid::CellAt obstacle() const;

 private:
  nav::Landmark landmark(nav::LandmarkKind kind, grid::CellAt cell, grid::Direction heading);
  nav::Landmark end_of_line();
  bool goes_on();
  nav::Landmark met();
  nav::Landmark first_follow();
  void turn_around();
  bool is_junction() const;
  bool faces_obstacle() const;

  CellRobot& robot_;
  grid::CellAt cell_;
  std::uint32_t cost_ = 0;
  std::uint64_t counted_ = 0;                        ///< moves before the last landmark
  grid::Direction heading_ = grid::Direction::east;  ///< of the last landmark
  bool on_junction_ = false;                         ///< the last landmark
  grid::Direction arm_ = grid::Direction::east;
  enum class Pending : std::uint8_t {
    nothing,
    first,    ///< has begun in the middle of a line
    blocked,  ///< looks at an obstacle on arm_ of the junction on which it stands
    back      ///< has turned its back on that
  } pending_ = Pending::nothing;
};

}  // namespace robosim::cells
