// Scores a drag race by UKMARS' rules of August 2022 (ukmars.org, contest rules). The robot drives along a
// straight line and over the finish line as fast as possible. The robot then stops within the braking
// distance.
//
// The clock starts at the starting signal ([race] signal). Without a signal, it starts when the robot has
// moved by 1 cm. The clock stops when the robot's outline first covers the middle of the finish line. The
// penalty is 5 s for overrunning the braking distance, for each touch of a barrier, and for each manual
// touch. A robot that starts before the signal is disqualified. The race ends when the robot has been at rest
// for 0.5 s after the finish line.
//
// Not modelled: the other lane.
#pragma once

#include <optional>
#include <string>

#include "sim/judge/rules_input.h"
#include "sim/map/map.h"

namespace robosim::judge {

class DragRace {
 public:
  /// Throws InputError if the map has no [race] with a braking distance.
  explicit DragRace(const map::Map& map);

  void look(const RulesInput& now, Events& events);
  bool reached() const { return rested_; }
  std::string summary() const;
  void score(result::Metrics& metrics) const;

 private:
  double time_s() const { return static_cast<double>(passed_ - began_) / 1e9; }
  double score_s() const;

  Vec2 finish_;     ///< middle of the finish line, m
  Vec2 limit_;      ///< end of the braking distance, m
  Vec2 direction_;  ///< unit vector along the lane
  std::optional<Vec2> origin_;
  SimTime began_ = kNever, passed_ = kNever, at_rest_since_ = kNever;
  SimTime signal_ = kNever;
  bool jumped_ = false, overran_ = false, in_hand_ = false, rested_ = false;
  int touches_ = 0, hands_ = 0;
};

}  // namespace robosim::judge
