// A drag race, by UKMARS' rules of August 2022 (ukmars.org, contest rules): along a straight line as fast as
// possible, over the finish line, and to a stop before the braking distance ends.
//
// The clock runs from the starting signal ([race] signal; without one from when the robot leaves its place,
// by 1 cm) until the robot's outline first covers the middle of the finish line. 5 s are added for
// overrunning the braking distance, for each touch of a barrier, and for a hand's touch. Who leaves before
// the signal is out. It is over when the robot has rested behind the finish line for 0.5 s. Left out: the
// other lane.
#pragma once

#include <optional>
#include <string>

#include "sim/grid/map.h"
#include "sim/judge/glance.h"

namespace robosim::judge {

class DragRace {
 public:
  /// Throws InputError if the map has no [race] with a braking distance.
  explicit DragRace(const grid::Map& map);

  void look(const Glance& now, Events& events);
  bool reached() const { return rested_; }
  std::string summary() const;
  void score(wire::Metrics& metrics) const;

 private:
  double time_s() const { return static_cast<double>(passed_ - began_) / 1e9; }
  double score_s() const;

  Vec2 finish_;     ///< the middle of the line, m
  Vec2 limit_;      ///< where the braking distance ends
  Vec2 direction_;  ///< a unit vector
  std::optional<Vec2> origin_;
  SimTime began_ = kNever, passed_ = kNever, at_rest_since_ = kNever;
  SimTime signal_ = kNever;
  bool jumped_ = false, overran_ = false, in_hand_ = false, rested_ = false;
  int touches_ = 0, hands_ = 0;
};

}  // namespace robosim::judge
