// The robot on cells, as a Walker for the navigator (firmware/src/nav/Landmark.h).
//
// Its moves are v1's. At a junction the first way out to the right of its entry is choose_right. The last is
// choose_left, and the one between them is step_forward. The way back is turn_around and step_forward. Places
// are the map's cells. A grid has a compass: heading 0 is east, whichever way the robot faces when it begins.
//
// A line is the same from both ends. So without a watcher of each move, the way along a line is walked once,
// and the walker records it. It may go back over the last line that it has not returned over yet. Then it is
// at its other end at once, with an equal number of counted moves. An explorer does so with every line of a
// tree.
//
// If an obstacle is directly next to a junction, the robot sees it before it moves. It does not have to leave
// the junction to find it, and finding it costs no move.
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

  /// Returns the landmark, known from the map at no cost. A robot at a line's end that faces away turns
  /// round, which is a move.
  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place&) {}
  /// Notes that the robot was put onto a line's end, facing along it.
  void reset();

  /// Return data of the last landmark: its cell, the moves before it, and, if it is `blocked`, the obstacle's
  /// place.
  grid::CellAt cell() const { return cell_; }
  std::uint32_t cost() const { return cost_; }
  grid::CellAt obstacle() const;

 private:
  // A line that was followed, in the backward direction.
  struct Way {
    std::uint32_t node;        ///< the cell where it ended
    std::uint32_t to;          ///< the cell where it began
    std::uint32_t moves;       ///< between them; 0 = unknown
    grid::Direction out;       ///< leaving `node`
    grid::Direction arriving;  ///< at `to`
  };
  static constexpr std::size_t kMostWays = 65'536;  // 1 MB; the oldest are dropped

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
  grid::Direction out_ = grid::Direction::east;  ///< of the robot's exit
  std::vector<Way> ways_;                        ///< not returned over yet, in the order of walking
  std::uint32_t cost_ = 0;
  std::uint64_t counted_ = 0;                        ///< moves before the last landmark
  grid::Direction heading_ = grid::Direction::east;  ///< of the last landmark
  bool on_junction_ = false;                         ///< the last landmark
  grid::Direction arm_ = grid::Direction::east;
  enum class Pending : std::uint8_t {
    nothing,
    first,    ///< has begun in the middle of a line
    blocked,  ///< faces an obstacle on arm_ of its junction
    back      ///< has turned away from that
  } pending_ = Pending::nothing;
};

}  // namespace robosim::cells
