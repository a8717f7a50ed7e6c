// Stores changes of the floor's paint during a run. Each change is a rectangle of line paint or of bare
// floor, parallel to the floor's edges. Later rectangles cover earlier ones.
#pragma once

#include <vector>

#include "sim/base/vec.h"

namespace robosim::world {

class RuntimePaint {
 public:
  struct Rectangle {
    int id = 0;
    Vec2 least, most;  ///< corners, m
    bool line = false;
  };
  /// The state that changes during a run.
  struct State {
    std::vector<Rectangle> patches;
    int next_id = 1;
    int changes = 0;
  };

  bool empty() const { return state_.patches.empty(); }
  /// Returns the number of changes so far. Each change invalidates earlier readings of the floor.
  int changes() const { return state_.changes; }
  int add(Vec2 least, Vec2 most, bool line);
  /// Removes a patch. Does nothing if the patch does not exist.
  void remove(int id);

  /// Returns the coverage or darkness of a square of side `footprint` about p. `below` is the value without
  /// patches. `line` and `bare` are the values of a square that a patch of line, or of bare floor, covers
  /// completely.
  double over(double below, double line, double bare, Vec2 p, double footprint) const;

  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  State state_;
};

}  // namespace robosim::world
