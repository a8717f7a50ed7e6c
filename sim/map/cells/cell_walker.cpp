#include "sim/map/cells/cell_walker.h"

#include <bit>

#include "sim/map/cells/quick.h"

namespace robosim::cells {

using map::CellAt;
using map::Direction;
using nav::Landmark;
using nav::LandmarkKind;

namespace {

// Returns the directions in which lines leave the robot's cell, including lines under obstacles.
unsigned lines_at(const CellRobot& robot) {
  const CellFloor& floor = robot.floor();
  if (!floor.is_near_obstacle(robot.at())) return floor.open_neighbours(robot.at());
  return map::line_neighbours(floor.map(), robot.pose().cell);
}

unsigned count(unsigned lines) {
  constexpr std::uint8_t kCounts[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  return kCounts[lines];
}

nav::Heading heading_of(Direction d) { return static_cast<nav::Heading>(d); }

}  // namespace

inline Landmark CellWalker::landmark(LandmarkKind kind, CellAt cell, Direction heading, unsigned arms) {
  on_junction_ = kind == LandmarkKind::junction;
  heading_ = heading;
  cell_ = cell;
  node_ = robot_.floor().index_of(cell);
  cost_ = static_cast<std::uint32_t>(robot_.moves() - counted_);
  counted_ = robot_.moves();
  return {kind, static_cast<std::uint8_t>(arms), heading_of(heading), {cell.x, cell.y}, cost_};
}

Landmark CellWalker::landmark(LandmarkKind kind, CellAt cell, Direction heading) {
  return landmark(kind, cell, heading,
                  kind == LandmarkKind::end ? 1u << static_cast<int>(reversed(heading)) : lines_at(robot_));
}

Landmark CellWalker::begin() {
  const map::Map& map = robot_.floor().map();
  const CellPose pose = robot_.pose();
  counted_ = robot_.moves();
  pending_ = Pending::nothing;
  ways_.clear();
  if (!robot_.floor().is_open(robot_.at())) return landmark(LandmarkKind::lost, pose.cell, pose.facing);
  const unsigned lines = lines_at(robot_);
  if (count(lines) >= 3) return landmark(LandmarkKind::junction, pose.cell, pose.facing);
  if (!map::is_dead_end(map, pose.cell)) {
    pending_ = Pending::first;
    return landmark(LandmarkKind::line, pose.cell, pose.facing);
  }
  Landmark at = landmark(LandmarkKind::end, pose.cell, pose.facing);
  at.arms = static_cast<std::uint8_t>(lines);
  if (lines == 0) return at;
  const auto along = static_cast<Direction>(std::countr_zero(lines));
  if (pose.facing == reversed(along)) turn_around();
  at.heading = heading_of(along);
  out_ = along;
  return at;
}

bool CellWalker::faces_obstacle() const {
  return map::blocks_line(robot_.floor().map(), robot_.pose().cell, robot_.facing());
}

bool CellWalker::is_junction() const {
  return robot_.floor().is_near_obstacle(robot_.at()) && count(lines_at(robot_)) >= 3;
}

// Handles `no_path`: the line ends, an obstacle blocks it, or the robot has entered a wall at the line's end.
Landmark CellWalker::end_of_line() {
  const CellFloor& floor = robot_.floor();
  const CellPose pose = robot_.pose();
  if (!floor.is_open(robot_.at())) {
    const CellAt end = ahead(pose.cell, reversed(pose.facing));
    const bool stepped_off = floor.is_open(floor.index_of(end));
    return landmark(stepped_off ? LandmarkKind::end : LandmarkKind::lost, end, pose.facing);
  }
  // The line ends here if no obstacle blocks it. A wall on the line also counts as an obstacle.
  const bool may_be_blocked =
      floor.is_near_obstacle(robot_.at()) || floor.is_wall(floor.next(robot_.at(), pose.facing));
  const bool ends = !may_be_blocked || map::is_dead_end(floor.map(), pose.cell);
  return landmark(ends ? LandmarkKind::end : LandmarkKind::blocked, pose.cell, pose.facing);
}

// Makes one move along the line. Returns false if the line does not continue.
inline bool CellWalker::goes_on() {
  if (is_junction()) return false;
  switch (robot_.sense()) {
    case Sense::straight:
      robot_.step_forward();
      return true;
    case Sense::right_turn:
      robot_.turn_right();
      return true;
    case Sense::left_turn:
      robot_.turn_left();
      return true;
    default:
      return false;
  }
}

// Continues to the next landmark. If no obstacle is near, the cell's byte alone shows a junction. Unless a
// wall is ahead, it also shows the end of the line: the only line is then behind the robot.
Landmark CellWalker::met() {
  const CellFloor& floor = robot_.floor();
  const Spot spot = robot_.spot();
  const std::uint8_t byte = floor.byte(spot.at);
  if (robot_.free_moves() > 0 && (byte & ~kNeighbours) == kOpen) {
    const unsigned sides = byte & kNeighbours;
    if (count(sides) >= 3)
      return landmark(LandmarkKind::junction, floor.cell_at(spot.at), spot.facing, sides);
    const unsigned behind = 1u << static_cast<int>(reversed(spot.facing));
    if (sides == behind && !floor.is_wall(floor.next(spot.at, spot.facing)))
      return landmark(LandmarkKind::end, floor.cell_at(spot.at), spot.facing, behind);
  }
  while (goes_on()) {
  }
  const bool junction = is_junction() || robot_.sense() == Sense::junction;
  return junction ? landmark(LandmarkKind::junction, robot_.pose().cell, robot_.facing()) : end_of_line();
}

// Follows a line from its middle: ahead if possible, otherwise to the right, to the left, or back.
Landmark CellWalker::first_follow() {
  pending_ = Pending::nothing;
  const unsigned lines = lines_at(robot_);
  const auto is_open = [&](Direction d) {
    return robot_.floor().is_open(robot_.floor().next(robot_.at(), d));
  };
  const Direction facing = robot_.facing();
  if (has(lines, facing)) {
    if (!is_open(facing)) return landmark(LandmarkKind::blocked, robot_.pose().cell, facing);
    robot_.step_forward();
  } else if (is_open(turned_right(facing))) {
    robot_.turn_right();
  } else if (is_open(turned_left(facing))) {
    robot_.turn_left();
  } else if (is_open(reversed(facing))) {
    if (faces_obstacle()) return landmark(LandmarkKind::blocked, robot_.pose().cell, facing);
    turn_around();
    robot_.step_forward();
  } else {
    return landmark(LandmarkKind::blocked, robot_.pose().cell, facing);
  }
  const CellPose begun = robot_.pose();
  do {
    if (!goes_on()) return met();
  } while (robot_.pose() != begun);
  return landmark(LandmarkKind::loop, robot_.pose().cell, robot_.facing());
}

Landmark CellWalker::follow() {
  switch (pending_) {
    case Pending::first:
      return first_follow();
    case Pending::blocked:
      return landmark(LandmarkKind::blocked, robot_.pose().cell, arm_);
    case Pending::back:
      pending_ = Pending::nothing;
      return landmark(LandmarkKind::junction, robot_.pose().cell, reversed(arm_));
    case Pending::nothing:
      break;
  }
  if (goes_back()) return met();
  const CellFloor& floor = robot_.floor();
  const std::size_t from = node_;
  const Direction out = out_;
  const Spot begun = robot_.spot();
  Spot spot = begun;
  const std::uint64_t plain = run_along(floor, spot, robot_.free_moves());
  robot_.made(plain, spot);
  const std::uint64_t moves = robot_.moves();
  const Landmark at = met();
  const bool is_same_back =
      floor.is_open(from) && begun == Spot{floor.next(from, out), out} && robot_.moves() == moves;
  if (ways_.size() == kMostWays) ways_.erase(ways_.begin(), ways_.begin() + kMostWays / 2);
  ways_.push_back({static_cast<std::uint32_t>(node_), static_cast<std::uint32_t>(from),
                   is_same_back ? static_cast<std::uint32_t>(plain + 1) : 0, reversed(heading_),
                   reversed(out)});
  return at;
}

// Returns whether the robot goes back over the last recorded line. If the line's number of moves is known,
// first puts the robot at the line's other end.
bool CellWalker::goes_back() {
  if (ways_.empty()) return false;
  const Way way = ways_.back();
  if (way.node != node_ || way.out != out_) return false;
  ways_.pop_back();
  const Spot spot = robot_.spot();
  const bool has_left = spot.at == robot_.floor().next(node_, out_);  // the robot has left a junction
  const std::uint64_t moves = way.moves - (has_left ? 1 : 0);
  if (way.moves > 0 && spot.facing == out_ && (has_left || spot.at == node_) && moves <= robot_.free_moves())
    robot_.made(moves, {way.to, way.arriving});
  return true;
}

void CellWalker::reset() {
  ways_.clear();
  pending_ = Pending::nothing;
  on_junction_ = false;
  counted_ = robot_.moves();
}

// Turns round. The move does not count in the line's length.
void CellWalker::turn_around() {
  robot_.turn_around();
  counted_ = robot_.moves();
}

CellAt CellWalker::obstacle() const {
  if (pending_ == Pending::blocked) return ahead(cell_, arm_);
  // The obstacle is in the line's direction: ahead, or to a side in a bend.
  const unsigned onward = lines_at(robot_) & ~(1u << static_cast<int>(reversed(heading_)));
  const auto to = onward == 0 ? heading_ : static_cast<Direction>(std::countr_zero(onward));
  return ahead(cell_, to);
}

void CellWalker::leave(nav::Turn turn) {
  if (pending_ == Pending::blocked) {
    pending_ = Pending::back;
    return;
  }
  if (!on_junction_) {
    out_ = reversed(heading_);
    turn_around();
    return;
  }
  const auto is_open = [&](Direction d) {
    return robot_.floor().is_open(robot_.floor().next(robot_.at(), d));
  };
  const auto out = static_cast<Direction>(turned(heading_of(heading_), turn));
  if (!is_open(out)) {
    pending_ = Pending::blocked;
    arm_ = out;
    return;
  }
  out_ = out;
  const Direction facing = robot_.facing();
  if (robot_.free_moves() >= 2) {
    if (out == reversed(facing)) turn_around();
    return robot_.made(1, {robot_.floor().next(robot_.at(), out), out});
  }
  const Direction right = turned_right(facing), left = turned_left(facing);
  if (out == reversed(facing)) {
    turn_around();
    robot_.step_forward();
  } else if (out == right || (out == facing && !is_open(right))) {
    robot_.choose_right();
  } else if (out == left || (out == facing && !is_open(left))) {
    robot_.choose_left();
  } else {
    robot_.step_forward();
  }
}

}  // namespace robosim::cells
