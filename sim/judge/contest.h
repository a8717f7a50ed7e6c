// Applies the rules of a competition to a run. A contest watches the run, scores it, and decides when it is
// over.
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
  /// Selects the rules, if the goal is a competition. Throws InputError if the map lacks anything that the
  /// rules require. `start` is the robot's position at the start.
  Contest(const Goal& goal, const map::Map& map, Vec2 start);

  explicit operator bool() const { return !std::holds_alternative<std::monostate>(rules_); }
  void look(const RulesInput& now, Events& events);
  bool reached() const;
  /// Returns whether the time limit of the rules has expired.
  bool over(SimTime t) const;
  /// Handles a robot that is lost or stuck. Returns true if the contest continues with a manual move.
  bool give_up(Events& events);
  /// Returns the pose to which a pending manual move puts the robot, and clears the pending move.
  std::optional<Pose> take_hand();
  /// Returns one clause that states the progress or the score.
  std::string summary() const;
  /// Sets the score, its parts and the run's time, if they exist.
  void score(result::Metrics& metrics) const;

 private:
  std::variant<std::monostate, Race, DragRace, MazeTries, RescueRun> rules_;
};

}  // namespace robosim::judge
