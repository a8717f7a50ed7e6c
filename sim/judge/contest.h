// The rules of a competition. A contest watches a run, scores it, and decides when it is over.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/judge/drag_race.h"
#include "sim/judge/maze_tries.h"
#include "sim/judge/race.h"
#include "sim/judge/rescue_run.h"

namespace robosim::judge {

struct Goal;

class Contest {
 public:
  /// Selects the rules; none if the goal is not a competition's. Throws InputError if this map lacks what its
  /// rules need. `start`: where the robot begins.
  Contest(const Goal& goal, const grid::Map& map, Vec2 start);

  explicit operator bool() const { return !std::holds_alternative<std::monostate>(rules_); }
  void look(const RulesInput& now, Events& events);
  bool reached() const;
  /// Returns whether the time limit of the rules is over.
  bool over(SimTime t) const;
  /// Handles a robot that is lost or stuck. Returns true if the rules continue; then a manual move follows.
  bool give_up(Events& events);
  /// Returns the target of a manual move now, once.
  std::optional<Pose> take_hand();
  /// Returns one clause: the progress, or the score.
  std::string summary() const;
  /// Sets score, its parts and the run's time, as far as they exist.
  void score(wire::Metrics& metrics) const;

 private:
  std::variant<std::monostate, Race, DragRace, MazeTries, RescueRun> rules_;
};

}  // namespace robosim::judge
