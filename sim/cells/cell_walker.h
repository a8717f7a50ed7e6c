// The robot on cells, as a Walker for the navigator (firmware/src/nav/Landmark.h).
//
// Its moves are v1's. At a junction the first way out to the right of the one it came by is choose_right, the
// last is choose_left, and the one between them is step_forward; the way back is turn_around and
// step_forward. Places are the map's cells. A grid has a compass: heading 0 is east, whichever way the robot
// faces when it begins.
//
// A line is the same from both ends. So while nobody asks after each move, the way along a line is walked
// once: the walker notes what it ran along, and if it goes back over the last line that it has not come back
// over yet, it is at its other end at once, with as many moves counted. An explorer does so with every line
// of a tree.
//
// If an obstacle is right beside a junction, the robot sees it before it moves: it does not have to leave the
// junction to find it, and finding it costs no move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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
  // A line that was run along, as it leads back.
  struct Way {
    std::uint32_t node;        ///< the cell where it ended
    std::uint32_t to;          ///< the cell where it began
    std::uint32_t moves;       ///< from one to the other; 0 = not known
    grid::Direction out;       ///< leaving `node`
    grid::Direction arriving;  ///< at `to`
  };
  static constexpr std::size_t kMostWays = 65'536;  // 1 MB; the oldest are forgotten

  bool goes_back();
  nav::Landmark landmark(nav::LandmarkKind kind, grid::CellAt cell, grid::Direction heading);
  nav::Landmark landmark(nav::LandmarkKind kind, grid::CellAt cell, grid::Direction heading, unsigned arms);
  nav::Landmark end_of_line();
  bool goes_on();
  nav::Landmark met();
  nav::Landmark first_follow();
  void turn_around();
  bool is_junction() const;
  bool faces_obstacle() const;

  CellRobot& robot_;
  grid::CellAt cell_;
  std::size_t node_ = 0;                         ///< the number of that cell
  grid::Direction out_ = grid::Direction::east;  ///< in which the robot leaves it
  std::vector<Way> ways_;                        ///< that it has not come back over, the last one last
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
