// A run against the clock, as Robotrace has it (NTF, rules 1-7 and 2-8): over the start line, along the whole
// course, over the goal line, and to rest in the area between the two.
#pragma once

#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/grid/map.h"

namespace robosim::world {
class Body;
}

namespace robosim::judge {

class Race {
 public:
  /// Throws InputError if the map has no [race].
  explicit Race(const grid::Map& map);

  /// Takes what the body has passed by now; true if it has just passed the goal line.
  bool advance(const world::Body& body, SimTime t);
  /// Whether it has passed the goal line, and been at rest in the area for 2 s.
  bool rests(const world::Body& body, bool at_rest, SimTime t);

  /// From the start line to the goal line, s: the score. A line is passed when the body's outline first
  /// covers the middle of it, as a gate of light would see it.
  double time_s() const { return static_cast<double>(ended_ - began_) * 1e-9; }
  /// One clause: how far it has come.
  std::string summary() const;

 private:
  struct Course {
    std::vector<Vec2> points;  ///< from the start line to the goal line, close together
    std::vector<Vec2> area;    ///< from the goal line to the start line
    double length = 0.0;       ///< m
  };
  Course course_;
  std::size_t next_ = 0;
  SimTime began_ = 0, ended_ = kNever;
  SimTime at_rest_since_ = kNever;
  bool rested_ = false;
};

}  // namespace robosim::judge
