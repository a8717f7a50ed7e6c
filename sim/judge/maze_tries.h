// Scores a line maze by LVBots' rules (lvbots.org, line maze rules). The robot drives from the start to the
// disc at the maze's end in the shortest time. The best of up to three tries counts. If the robot stops on
// the disc, 10 s are deducted.
//
// A try begins when the robot has left the start by 1 cm. The clock stops when the robot's outline first
// touches the disc. The try ends when the robot has been at rest on the disc for 1 s, or has left the disc.
// The next try requires a manual move back to the start. A manual move before the robot has touched the disc
// ends the try without a result.
//
// The rules' limit of 10 minutes for all tries is not checked here: the run has its own time limit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/judge/rules_input.h"
#include "sim/map/map.h"

namespace robosim::judge {

class MazeTries {
 public:
  static constexpr int kMost = 3;

  /// Throws InputError if the map has no goal, or no disc at the goal.
  MazeTries(const map::Map& map, Vec2 start, int tries);

  void look(const RulesInput& now, Events& events);
  bool reached() const { return done_ == tries_ && best(); }
  std::string summary() const;
  void score(result::Metrics& metrics) const;

 private:
  enum class Phase {
    waiting,  ///< on the start
    driving,
    on_disc,  ///< has touched the disc
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
  std::vector<Vec2> disc_;  ///< points of the disc
  Phase phase_ = Phase::waiting;
  int done_ = 0;  ///< number of completed tries, including tries without a result
  std::vector<Try> finished_;
  std::optional<Vec2> seen_at_;
  Vec2 waited_at_;
  SimTime began_ = 0, touched_ = 0, at_rest_since_ = kNever;
};

}  // namespace robosim::judge
