// A line maze, by LVBots' rules (lvbots.org, line maze rules): from the start to the disc at the maze's end
// in as little time as possible. Of up to three tries the best counts, and 10 s are taken off the time of a
// robot that is stopped on the disc.
//
// A try begins where the robot leaves the start, by 1 cm, and its clock stops where its outline first touches
// the disc. Then it is over once the robot has rested there for 1 s, or has left the disc. The next one
// begins once a hand has put the robot back on the start; put anywhere else it is out of the try. That the
// tries take 10 minutes at most is for the run's limit to see to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/grid/map.h"
#include "sim/judge/glance.h"

namespace robosim::judge {

class MazeTries {
 public:
  static constexpr int kMost = 3;

  /// Throws InputError if the map has no goal, or no disc there.
  MazeTries(const grid::Map& map, Vec2 start, int tries);

  void look(const Glance& now, Events& events);
  bool reached() const { return done_ == tries_ && best(); }
  std::string summary() const;
  void score(wire::Metrics& metrics) const;

 private:
  enum class Phase {
    waiting,  ///< on the start
    driving,
    on_disc,  ///< has touched it
    over,
  };
  struct Try {
    double time_s = 0.0;
    bool stopped = false;
    double score() const;
  };
  const Try* best() const;
  bool touches_disc(const world::Body& body) const;
  void finish_try(bool stopped, Events& events);

  Vec2 start_;
  int tries_;
  std::vector<Vec2> disc_;  ///< points of it
  Phase phase_ = Phase::waiting;
  int done_ = 0;  ///< tries that are over
  std::vector<Try> finished_;
  std::optional<Vec2> seen_at_;
  Vec2 waited_at_;
  SimTime began_ = 0, touched_ = 0, at_rest_since_ = kNever;
};

}  // namespace robosim::judge
