// Plays a scenario: fires each step when it is due, and undoes what has a duration.
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
#include "sim/grid/map.h"
#include "sim/judge/goal.h"
#include "sim/judge/script_fault.h"
#include "sim/robot/robot.h"
#include "sim/scenario/board_faults.h"
#include "sim/scenario/hand_motion.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/world_changes.h"
#include "sim/world/world.h"

namespace robosim::scenario {

/// What a scenario may touch.
struct Stage {
  const grid::Map& map;
  const grid::Stripes& stripes;
  robot::Robot& robot;
  world::World& world;
  world::Body& body;
  exec::Executor& executor;
  std::uint64_t seed;
  std::uint32_t number;  ///< of the robot in its world
  Profile profile;       ///< `ideal` leaves each figure of a script in the middle of its spread
};

/// Limits of a script, so that each of its steps costs the same however many there are: all steps, those that
/// wait for an event (each is looked at in each tick), the cells that obstacles are put on,
/// and lines that paint, erase or move a door.
inline constexpr std::size_t kMostSteps = 100'000, kMostAwaited = 1000, kMostObstacles = 1000,
                             kMostChanges = 100;

class ScenarioPlayer {
 public:
  /// Throws InputError, with the script's line, for parts, faults, stations and places that do not exist, and
  /// beyond the limits.
  ScenarioPlayer(std::vector<Step> steps, const Stage& stage, const judge::Progress& progress);

  /// Adds steps at the script's end; all or none. Throws as the constructor does.
  void add(std::vector<Step> steps, const judge::Progress& progress);

  /// Carries out what is due at `t`, the beginning of a tick; what it did is appended to `events`.
  void act(SimTime t, const judge::Progress& progress, judge::Events& events) {
    if (next_act(t) <= t) act_now(t, progress, events);
  }
  /// When it does something next, nobody having added steps; `t`, which is now, where it may do so at any
  /// time.
  SimTime next_act(SimTime t) const {
    if (!state_.awaiting.empty() || state_.sweep || state_.tilt || changes_.go_on()) return t;
    return std::min(state_.timed.empty() ? kNever : state_.timed.begin()->first.first,
                    state_.undo.empty() ? kNever : state_.undo.begin()->first.first);
  }
  /// The battery sags and recovers by itself: at the beginning of a tick it gives so many volts.
  void feed(double volts, SimTime t, judge::Events& events);
  /// A part has told something that people would see or hear.
  void hear(const robot::Told& told);
  /// The firmware has sent a byte.
  void hear(std::uint8_t byte);
  bool powered() const { return board_.powered(); }
  judge::Power power() const { return board_.power(); }
  /// What the script has broken so far, in the order of time.
  const std::vector<judge::ScriptFault>& faults() const { return state_.faults; }
  /// How often the chip has started.
  std::uint64_t boots() const { return board_.boots(); }
  /// Writes of the firmware to its EEPROM, so far.
  std::uint64_t eeprom_writes() const { return board_.eeprom_writes(); }

  /// What a script's words ask for.
  using ReadFault = std::variant<BoardFault, robot::PartFault>;
  struct Pending {
    std::uint64_t number;  ///< its place in the script
    Step step;
    std::optional<ReadFault> fault;  ///< of an action that is one
    bool heard = false;              ///< the text it waits for has come
  };
  struct Undo {
    std::uint64_t number;  ///< counted in the order in which they began
    Action action;
    std::optional<ReadFault> fault;  ///< of an action that is one
  };
  /// When something is due, and its number.
  using Moment = std::pair<SimTime, std::uint64_t>;
  template <class T>
  using Due = std::map<Moment, T>;

  /// What changes during a run, but for what the script has changed elsewhere.
  struct State {
    std::uint64_t steps = 0, undos = 0;  ///< so far
    Due<Pending> timed;
    std::vector<Pending> awaiting;  ///< an event, in the script's order
    Due<Undo> undo;
    /// Where in `undo` that is which a later action about the same thing makes void.
    std::map<std::string, Moment> lasting;
    /// What fingers are on, and when each leaves it, as in `undo`; kNever: it stays.
    std::map<std::string, std::set<Moment>> fingers;
    std::optional<Sweep> sweep;
    std::optional<Tilt> tilt;
    std::set<std::pair<int, int>> obstacle_cells;  ///< that the script names
    std::size_t change_lines = 0;                  ///< that paint, erase or move a door
    std::vector<judge::ScriptFault> faults;
    std::map<std::string, std::size_t> broken;  ///< a part's fault that has not ended, in `faults`
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
  /// Of a step that waits for an event: whether that has happened.
  bool met(const Pending& pending, const judge::Progress& progress) const;
  void note_finger(const Action& action, const Moment& due);
  void carry_out(Pending pending, SimTime t, judge::Events& events);
  wire::RunEvent::What perform(const Action& action, const std::optional<ReadFault>& fault, SimTime t);
  wire::RunEvent::What break_or_repair(const Action& action, const ReadFault& fault, SimTime t);
  wire::RunEvent::What switch_power(const Action& action, SimTime t);
  /// Undoes what lasted for a time. A key of a remote control is held by the part itself: its end is no
  /// event.
  std::optional<wire::RunEvent::What> end(const Undo& undo, SimTime t);
  void bring_about(const ReadFault& fault, SimTime t);
  void repair(const ReadFault& fault, SimTime t);
  void note_repair(const std::string& part, SimTime t);
  /// Draws what has a spread; throws InputError if not all of it is possible.
  void draw(Step& step, const judge::Progress& progress) const;
  /// Throws InputError, with the step's place. Gives its fault, if it is one.
  std::optional<ReadFault> check(const Step& step, const judge::Progress& progress) const;
  /// The arguments begin with the kind.
  ReadFault read_fault(const std::string& part, const std::vector<std::string>& arguments, bool ends) const;

  const Stage stage_;
  BoardFaults board_;
  WorldChanges changes_;
  State state_;
};

}  // namespace robosim::scenario
