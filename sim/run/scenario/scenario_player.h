// Plays a scenario: runs each step when it is due, and undoes steps with a duration.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/base/profile.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/goal.h"
#include "sim/judge/script_fault.h"
#include "sim/map/map.h"
#include "sim/robot/robot.h"
#include "sim/run/scenario/board_faults.h"
#include "sim/run/scenario/hand_motion.h"
#include "sim/run/scenario/scenario.h"
#include "sim/run/scenario/world_changes.h"
#include "sim/world/world.h"

namespace robosim::scenario {

/// The objects that a scenario may change.
struct Stage {
  const map::Map& map;
  const map::Stripes& stripes;
  robot::Robot& robot;
  world::World& world;
  world::Body& body;
  exec::Executor& executor;
  std::uint64_t seed;
  std::uint32_t number;  ///< number of the robot in its world
  Profile profile;       ///< with `ideal`, each value with a spread gets the middle of its spread
};

/// Limits of a script, which bound the cost of a tick. kMostSteps limits the number of steps. kMostAwaited
/// limits the steps that wait for an event, because each tick checks all of them. kMostObstacles limits the
/// cells with obstacles. kMostChanges limits the lines that paint, erase or move a door.
inline constexpr std::size_t kMostSteps = 100'000, kMostAwaited = 1000, kMostObstacles = 1000,
                             kMostChanges = 100;

class ScenarioPlayer {
 public:
  /// Throws InputError, with the script's line, for unknown parts, faults, stations and places, and for
  /// scripts beyond the limits.
  ScenarioPlayer(std::vector<Step> steps, const Stage& stage, const judge::Progress& progress);

  /// Adds steps at the script's end. If a step is invalid, throws the same errors as the constructor, and
  /// adds no steps.
  void add(std::vector<Step> steps, const judge::Progress& progress);

  /// Runs the steps that are due at `t`, the beginning of a tick; appends their effects to `events`.
  void act(SimTime t, const judge::Progress& progress, judge::Events& events) {
    if (next_act(t) <= t) act_now(t, progress, events);
  }
  /// Returns the time of the next action. Steps that are added later may be due earlier. Returns the current
  /// time `t` if an action may be due in any tick.
  SimTime next_act(SimTime t) const {
    if (!state_.awaiting.empty() || state_.sweep || state_.tilt || changes_.go_on()) return t;
    return std::min(state_.timed.empty() ? kNever : state_.timed.begin()->first.first,
                    state_.undo.empty() ? kNever : state_.undo.begin()->first.first);
  }
  /// Sets the voltage that a [battery] supplies, at the beginning of a tick. It sags and recovers by itself.
  void feed(double volts, SimTime t, judge::Events& events);
  /// Receives a text that a part shows or sends to people.
  void hear(const robot::PartText& told);
  /// Receives a byte from the firmware.
  void hear(std::uint8_t byte);
  bool powered() const { return board_.powered(); }
  judge::SupplySummary power() const { return board_.power(); }
  /// Returns the faults of the script so far, by time.
  const std::vector<judge::ScriptFault>& faults() const { return state_.faults; }
  /// Returns how often the chip has started so far.
  std::uint64_t boots() const { return board_.boots(); }
  /// Returns the number of EEPROM writes that the firmware has begun so far.
  std::uint64_t eeprom_writes() const { return board_.eeprom_writes(); }

  /// A fault that a script requests.
  using ReadFault = std::variant<BoardFault, robot::PartFault>;
  struct Pending {
    std::uint64_t number;  ///< index of the step in the script
    Step step;
    std::optional<ReadFault> fault;  ///< set if the action is a fault
    bool heard = false;              ///< the awaited text has occurred
  };
  struct Undo {
    std::uint64_t number;  ///< number of the action; actions are numbered in the order of their beginnings
    Action action;
    std::optional<ReadFault> fault;  ///< set if the action is a fault
  };
  /// The time at which a step or the end of an action is due, and its number.
  using Moment = std::pair<SimTime, std::uint64_t>;
  template <class T>
  using Due = std::map<Moment, T>;

  /// The player's state that changes during a run. BoardFaults and WorldChanges have their own states.
  struct State {
    std::uint64_t steps = 0, undos = 0;  ///< the next free numbers of a Pending and an Undo
    Due<Pending> timed;
    std::vector<Pending> awaiting;  ///< steps that wait for an event, in the script's order
    Due<Undo> undo;
    /// For each result of subject_of(): the key in `undo` of the last action's end. A later action with the
    /// same result cancels this end.
    std::map<std::string, Moment> lasting;
    /// For each result of finger_of(): the fingers on the part. Each finger is a key in `undo`, with the time
    /// at which the finger leaves. If that time is kNever, the finger stays, and `undo` has no such key.
    std::map<std::string, std::set<Moment>> fingers;
    std::optional<Sweep> sweep;
    std::optional<Tilt> tilt;
    std::set<std::pair<int, int>> obstacle_cells;  ///< cells of obstacles that the script mentions
    std::size_t change_lines = 0;                  ///< number of lines that paint, erase or move a door
    std::vector<judge::ScriptFault> faults;
    std::map<std::string, std::size_t> broken;  ///< active faults of parts, as indices in `faults`
    std::string heard;
    std::size_t longest_text = 0;
  };
  struct Saved {
    State own;
    BoardFaults::State board;
    WorldChanges::State world;
  };
  Saved save() const { return {state_, board_.save(), changes_.save()}; }
  void restore(const Saved& saved);

 private:
  void act_now(SimTime t, const judge::Progress& progress, judge::Events& events);
  void check_limits(const std::vector<Step>& steps);
  void end_what_is_over(SimTime t, judge::Events& events);
  /// Returns whether the event that a step waits for has occurred.
  bool met(const Pending& pending, const judge::Progress& progress) const;
  void note_finger(const Action& action, const Moment& due);
  void carry_out(Pending pending, SimTime t, judge::Events& events);
  result::RunEvent::What perform(const Action& action, const std::optional<ReadFault>& fault, SimTime t);
  result::RunEvent::What break_or_repair(const Action& action, const ReadFault& fault, SimTime t);
  result::RunEvent::What switch_power(const Action& action, SimTime t);
  /// Undoes an action of limited duration. Returns nullopt for verbs that cannot have a duration.
  std::optional<result::RunEvent::What> end(const Undo& undo, SimTime t);
  void bring_about(const ReadFault& fault, SimTime t);
  void repair(const ReadFault& fault, SimTime t);
  void note_repair(const std::string& part, SimTime t);
  /// Draws values with a spread; throws InputError if any part of the range is invalid.
  void draw(Step& step, const judge::Progress& progress) const;
  /// Checks a step. Returns its fault if the step is a fault. Throws InputError with the step's place.
  std::optional<ReadFault> check(const Step& step, const judge::Progress& progress) const;
  /// Parses a fault. The arguments begin with the kind.
  ReadFault read_fault(const std::string& part, const std::vector<std::string>& arguments, bool ends) const;

  const Stage stage_;
  BoardFaults board_;
  WorldChanges changes_;
  State state_;
};

}  // namespace robosim::scenario
