// Simulates the robot of Robosim v1, which senses four cells and moves from cell to cell.
//
// The pose is a cell and a direction. The robot senses only four cells: the cells in front, on the right and
// on the left, and its own cell. Each move takes `speed` seconds.
//
//   step_forward   moves one cell ahead
//   turn_right     moves to the cell on the right, facing that way; turn_left mirrors this
//   turn_around    turns to the opposite direction, in place
//   choose_right   turn_right if the cell on the right is line, otherwise step_forward; choose_left mirrors
//                  this
//
// A move off the map, or onto an obstacle (`x`), leaves the robot on its cell, and still takes time. The
// robot may enter floor and walls, as in v1. If a line ends at a wall, the robot steps into the wall, senses
// `no_path` there, and turns round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "sim/base/noise.h"
#include "sim/map/cells/cell_floor.h"

namespace robosim::cells {

enum class Move : std::uint8_t {
  step_forward,
  turn_right,
  turn_left,
  turn_around,
  choose_right,
  choose_left
};
/// Returns "step_forward", …
const char* name_of(Move move);

struct CellPose {
  map::CellAt cell;
  map::Direction facing = map::Direction::east;
  bool operator==(const CellPose&) const = default;
};

/// Thrown by the first move beyond the limit.
struct OutOfMoves : std::runtime_error {
  OutOfMoves() : std::runtime_error("the robot has used up its moves") {}
};

/// Probabilities of errors, 0..1.
struct CellNoise {
  double miss = 0.0;  ///< per sensing: one of the four cells, chosen at random, does not look like line
  double slip = 0.0;  ///< per move: the robot stays on its cell
  std::uint64_t seed = 1;
};

/// Receives every move.
class MoveWatcher {
 public:
  /// `pose` and `sense` are from before the move, `clock` is from after the move. May throw to end the run.
  virtual void moved(const CellPose& pose, Sense sense, Move move, double clock) = 0;

 protected:
  ~MoveWatcher() = default;
};

class CellRobot {
 public:
  static constexpr std::uint64_t kEndless = ~std::uint64_t{0};

  /// `speed` is the number of seconds per move. `floor` must outlive this object.
  CellRobot(const CellFloor& floor, const CellPose& pose, double speed = 1.0)
      : floor_(floor), at_(floor.index_of(pose.cell)), facing_(pose.facing), speed_(speed) {}

  Sense sense() const { return noisy_ ? sense_with_noise() : floor_.sense(at_, facing_); }

  void step_forward() { go(Move::step_forward, facing_); }
  void turn_right() { go(Move::turn_right, turned_right(facing_)); }
  void turn_left() { go(Move::turn_left, turned_left(facing_)); }
  void turn_around() {
    if (begin(Move::turn_around)) facing_ = reversed(facing_);
  }
  void choose_right() { choose(Move::choose_right, turned_right(facing_)); }
  void choose_left() { choose(Move::choose_left, turned_left(facing_)); }

  CellPose pose() const { return {floor_.cell_at(at_), facing_}; }
  map::Direction facing() const { return facing_; }
  /// Returns the number of the robot's cell on the floor.
  std::size_t at() const { return at_; }
  std::uint64_t moves() const { return moves_; }
  double clock() const { return static_cast<double>(moves_) * speed_; }
  const CellFloor& floor() const { return floor_; }

  /// Puts the robot elsewhere, without a move.
  void place(const CellPose& pose) {
    at_ = floor_.index_of(pose.cell);
    facing_ = pose.facing;
  }
  /// Sets the total number of allowed moves. The first move beyond this number throws OutOfMoves.
  void limit_moves(std::uint64_t moves) {
    limit_ = moves;
    set_free();
  }
  /// Sets the watcher; null = none.
  void watch(MoveWatcher* watcher) {
    watcher_ = watcher;
    set_free();
  }
  void set_noise(const CellNoise& noise);

  Spot spot() const { return {at_, facing_}; }
  /// Returns the number of moves that the caller may record at once with made(). The result is 0 if the robot
  /// has a watcher or noise.
  std::uint64_t free_moves() const { return free_until_ > moves_ ? free_until_ - moves_ : 0; }
  /// Records `moves` moves at once, which took the robot to `there`.
  void made(std::uint64_t moves, const Spot& there) {
    moves_ += moves;
    at_ = there.at;
    facing_ = there.facing;
  }

 private:
  /// Counts a move. Returns false if the robot slips.
  bool begin(Move move) {
    if (moves_ >= free_until_) return begin_asking(move);
    ++moves_;
    return true;
  }
  void go(Move move, map::Direction d) {
    if (!begin(move)) return;
    const std::size_t next = floor_.next(at_, d);
    if (!floor_.is_shut(next)) at_ = next;
    facing_ = d;
  }
  void choose(Move move, map::Direction side) {
    go(move, floor_.is_open(floor_.next(at_, side)) ? side : facing_);
  }
  bool begin_asking(Move move);
  void set_free() { free_until_ = watcher_ || noisy_ ? 0 : limit_; }
  Sense sense_with_noise() const;
  bool slips() const;

  const CellFloor& floor_;
  std::size_t at_;
  map::Direction facing_;
  bool noisy_ = false;
  std::uint64_t moves_ = 0;
  std::uint64_t limit_ = kEndless;
  std::uint64_t free_until_ = kEndless;  ///< moves() may reach this number without checks
  double speed_;
  MoveWatcher* watcher_ = nullptr;
  double miss_ = 0.0, slip_ = 0.0;
  NoiseStream misses_, slips_;  // the sample number is the number of the move
};

}  // namespace robosim::cells
