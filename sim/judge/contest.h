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
  /// Nothing where the goal is no competition's. Throws InputError where its rules miss something on this
  /// map. `start`: where the robot begins.
  Contest(const Goal& goal, const grid::Map& map, Vec2 start);

  explicit operator bool() const { return !std::holds_alternative<std::monostate>(rules_); }
  void look(const Glance& now, Events& events);
  bool reached() const;
  /// Whether the time is up that the rules give.
  bool over(SimTime t) const;
  /// The robot is lost or stuck. True if the rules go on; then somebody puts it somewhere.
  bool give_up(Events& events);
  /// Where a hand puts the robot now, once.
  std::optional<Pose> take_hand();
  /// One clause: how far it has come, or what it has scored.
  std::string summary() const;
  /// Score, its parts and the run's time, where there are any yet.
  void score(wire::Metrics& metrics) const;

 private:
  std::variant<std::monostate, Race, DragRace, MazeTries, RescueRun> rules_;
};

}  // namespace robosim::judge
