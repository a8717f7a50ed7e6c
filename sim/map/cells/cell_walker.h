// Implements the navigator's Walker (firmware/src/nav/Landmark.h) with a robot that moves from cell to cell.
//
// The walker makes the moves of Robosim v1. At a junction, the ways out are counted from the right of the
// entry. `choose_right` takes the first way, `choose_left` the last way, and `step_forward` the way between
// them. To take the way back, the walker makes `turn_around` and then `step_forward`. Places are the map's
// cells. Heading 0 is always east, whatever the robot's first direction is.
//
// The walker records each line, because an explorer goes back over every line of a tree. If the robot goes
// back over the latest recorded line, the walker puts the robot directly at the other end. The line's moves
// are still counted. If a watcher must see each move, the robot makes all moves.
//
// If an obstacle is directly next to a junction, the robot senses the obstacle before it moves. Finding such
// an obstacle therefore takes no move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "firmware/src/nav/Landmark.h"
#include "sim/map/cells/cell_robot.h"

namespace robosim::cells {

class CellWalker {
 public:
  static constexpr bool kKnowsPlaces = true;

  explicit CellWalker(CellRobot& robot) : robot_(robot) {}

  /// Reads the landmark at the robot's place from the map. The only possible move is a `turn_around`: at a
  /// line's end, a robot that faces away from the line makes this move.
  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place&) {}
  /// Discards the records of lines. Call this after the robot was put onto the end of a line, facing along
  /// the line.
  void reset();

  /// Return the last landmark's cell, and the number of moves since the previous landmark.
  /// obstacle() is the place of the obstacle if the last landmark is `blocked`.
  map::CellAt cell() const { return cell_; }
  std::uint32_t cost() const { return cost_; }
  map::CellAt obstacle() const;

 private:
  // The way back over a line that was followed.
  struct Way {
    std::uint32_t node;       ///< cell where the line ended
    std::uint32_t to;         ///< cell where the line began
    std::uint32_t moves;      ///< number of moves between them; 0 = unknown
    map::Direction out;       ///< direction that leaves `node`
    map::Direction arriving;  ///< direction of arrival at `to`
  };
  static constexpr std::size_t kMostWays = 65'536;  // 1 MB; the oldest ways are dropped

  bool goes_back();
  nav::Landmark landmark(nav::LandmarkKind kind, map::CellAt cell, map::Direction heading);
  nav::Landmark landmark(nav::LandmarkKind kind, map::CellAt cell, map::Direction heading, unsigned arms);
  nav::Landmark end_of_line();
  bool goes_on();
  nav::Landmark met();
  nav::Landmark first_follow();
  void turn_around();
  bool is_junction() const;
  bool faces_obstacle() const;

  CellRobot& robot_;
  map::CellAt cell_;
  std::size_t node_ = 0;                       ///< number of cell_
  map::Direction out_ = map::Direction::east;  ///< direction in which the robot left node_
  std::vector<Way> ways_;                      ///< lines to go back over, oldest first
  std::uint32_t cost_ = 0;
  std::uint64_t counted_ = 0;                      ///< robot's number of moves at the last landmark
  map::Direction heading_ = map::Direction::east;  ///< heading at the last landmark
  bool on_junction_ = false;                       ///< the last landmark is a junction
  map::Direction arm_ = map::Direction::east;
  enum class Pending : std::uint8_t {
    nothing,
    first,    ///< the robot has begun in the middle of a line
    blocked,  ///< the robot faces an obstacle on arm_ of its junction
    back      ///< the robot has turned away from that obstacle
  } pending_ = Pending::nothing;
};

}  // namespace robosim::cells
