// Times a lap from the start line of the map's [race] to its goal line.
//
//   robotrace  NTF, rules 1-7 and 2-8: the robot must also come to rest between the two lines
//   ukmars     UK line follower: the run ends 2 s after the goal line, so that the sketch can report its time
//
// The time between the lines is the score.
#pragma once

#include <string>
#include <vector>

#include "sim/judge/rules_input.h"
#include "sim/map/map.h"

namespace robosim::judge {

class Race {
 public:
  enum class Finish { line, at_rest_in_area };

  /// Throws InputError if the map has no [race].
  Race(const map::Map& map, Finish finish);

  void look(const RulesInput& now, Events& events);
  /// Returns whether the robot has passed the goal line and, if required, rested between goal and start line
  /// for 2 s. If rest is not required, the run ends 2 s after the goal line.
  bool reached() const { return rested_; }
  std::string summary() const;
  void score(result::Metrics& metrics) const;

 private:
  /// Returns the score: the time in seconds from the start line to the goal line. A line is passed when the
  /// body's outline first covers the line's middle, like the beam of a light gate.
  double time_s() const { return static_cast<double>(ended_ - began_) * 1e-9; }
  void advance(const RulesInput& now, Events& events);
  bool rests(const RulesInput& now);

  struct Course {
    std::vector<Vec2> points;  ///< closely spaced points from the start line to the goal line
    std::vector<Vec2> area;    ///< closely spaced points from the goal line to the start line
    double length = 0.0;       ///< in metres
  };
  Finish finish_;
  Course course_;
  std::size_t next_ = 0;
  SimTime began_ = 0, ended_ = kNever;
  SimTime at_rest_since_ = kNever;
  bool rested_ = false;  ///< the race is complete
};

}  // namespace robosim::judge
