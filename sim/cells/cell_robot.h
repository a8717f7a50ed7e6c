// The robot of Robosim v1: it senses four cells and moves from cell to cell.
//
// Pose: a cell and a direction. It senses the cell in front, on the right, on the left and its own, relative
// to its direction; never behind, never diagonally. Each move adds `speed` to the clock, once.
//
//   step_forward   one cell ahead
//   turn_right     one cell to the right, facing that way; turn_left mirrors it
//   turn_around    the other way round, in place
//   choose_right   turn_right if that cell is line, else step_forward; choose_left mirrors it
//
// A move off the map, or onto an obstacle (`x`), leaves the robot on its cell; the time counts all the same.
// It may enter floor and walls, as in v1. At a wall at the end of a line it steps into the wall, senses
// `no_path` there, and turns round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "sim/base/noise.h"
#include "sim/cells/cell_floor.h"

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
  grid::CellAt cell;
  grid::Direction facing = grid::Direction::east;
  bool operator==(const CellPose&) const = default;
};

/// Thrown by the first move beyond the limit.
struct OutOfMoves : std::runtime_error {
  OutOfMoves() : std::runtime_error("the robot has used up its moves") {}
};

/// Probabilities of errors, 0..1.
struct CellNoise {
  double miss = 0.0;  ///< at each sensing: one of the four cells, chosen at random, is not seen as line
  double slip = 0.0;  ///< at each move: the robot does not move
  std::uint64_t seed = 1;
};

/// Called for every move.
class MoveWatcher {
 public:
  /// `pose` and `sense` are from before the move, `clock` is from after it. May throw to end the run.
  virtual void moved(const CellPose& pose, Sense sense, Move move, double clock) = 0;

 protected:
  ~MoveWatcher() = default;
};

class CellRobot {
 public:
  static constexpr std::uint64_t kEndless = ~std::uint64_t{0};

  /// `speed`: seconds per move. The floor must outlive this.
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
  grid::Direction facing() const { return facing_; }
  /// Returns the number of its cell on the floor.
  std::size_t at() const { return at_; }
  std::uint64_t moves() const { return moves_; }
  double clock() const { return static_cast<double>(moves_) * speed_; }
  const CellFloor& floor() const { return floor_; }

  /// Puts the robot elsewhere; costs nothing.
  void place(const CellPose& pose) {
    at_ = floor_.index_of(pose.cell);
    facing_ = pose.facing;
  }
  /// Sets the total number of moves that are allowed; the next one throws OutOfMoves.
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
  /// Returns the number of moves that need no checks: those up to the limit, none with a watcher or noise.
  std::uint64_t free_moves() const { return free_until_ > moves_ ? free_until_ - moves_ : 0; }
  /// Records `moves` free moves, which took it there.
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
  void go(Move move, grid::Direction d) {
    if (!begin(move)) return;
    const std::size_t next = floor_.next(at_, d);
    if (!floor_.is_shut(next)) at_ = next;
    facing_ = d;
  }
  void choose(Move move, grid::Direction side) {
    go(move, floor_.is_open(floor_.next(at_, side)) ? side : facing_);
  }
  bool begin_asking(Move move);
  void set_free() { free_until_ = watcher_ || noisy_ ? 0 : limit_; }
  Sense sense_with_noise() const;
  bool slips() const;

  const CellFloor& floor_;
  std::size_t at_;
  grid::Direction facing_;
  bool noisy_ = false;
  std::uint64_t moves_ = 0;
  std::uint64_t limit_ = kEndless;
  std::uint64_t free_until_ = kEndless;  ///< where free_moves() end
  double speed_;
  MoveWatcher* watcher_ = nullptr;
  double miss_ = 0.0, slip_ = 0.0;
  NoiseStream misses_, slips_;  // the sample number is that of the move
};

}  // namespace robosim::cells
