// Plays a scenario: fires each step when it is due, and undoes what has a duration.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/grid/map.h"
#include "sim/judge/goal.h"
#include "sim/judge/script_fault.h"
#include "sim/robot/robot.h"
#include "sim/scenario/board_faults.h"
#include "sim/scenario/scenario.h"
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
};

class ScenarioPlayer {
 public:
  /// Throws InputError, with the script's line, for parts, faults, stations and places that do not exist.
  ScenarioPlayer(std::vector<Step> steps, const Stage& stage, const judge::Progress& progress);

  /// Adds steps at the script's end; all or none. Throws as the constructor does.
  void add(std::vector<Step> steps, const judge::Progress& progress);

  /// Carries out what is due at `t`, the beginning of a tick; what it did is appended to `events`.
  void act(SimTime t, const judge::Progress& progress, judge::Events& events);
  /// The firmware has sent a byte.
  void hear(std::uint8_t byte);
  bool powered() const { return board_.powered(); }
  /// What the script has broken so far, in the order of time.
  const std::vector<judge::ScriptFault>& faults() const { return state_.faults; }
  /// Writes of the firmware to its EEPROM, so far.
  std::uint64_t eeprom_writes() const { return board_.eeprom_writes(); }

  /// What a script's words ask for.
  using ReadFault = std::variant<BoardFault, robot::PartFault>;
  struct Pending {
    Step step;
    std::optional<ReadFault> fault;  ///< of an action that is one
    bool heard = false;              ///< the serial text it waits for has come
    SimTime due = kNever;            ///< when its event was met, and the wait after it
  };
  struct Undo {
    SimTime at;
    Action action;
    std::optional<ReadFault> fault;  ///< of an action that is one
  };

  struct Obstacle {
    grid::CellAt cell;
    int number;  ///< the world's
  };
  /// What changes during a run, but for what the script has changed elsewhere.
  struct State {
    std::vector<Pending> pending;
    std::vector<Undo> undo;
    std::vector<Obstacle> obstacles;
    std::vector<judge::ScriptFault> faults;
    std::string heard;
    std::size_t longest_text = 0;
  };
  struct Saved {
    State own;
    BoardFaults::State board;
  };
  Saved save() const { return {state_, board_.save()}; }
  void restore(const Saved& saved);

 private:
  bool met(const Pending& pending, SimTime t, const judge::Progress& progress) const;
  wire::RunEvent::What perform(const Action& action, const std::optional<ReadFault>& fault, SimTime t);
  wire::RunEvent::What break_or_repair(const Action& action, const ReadFault& fault, SimTime t);
  wire::RunEvent::What switch_power(const Action& action, SimTime t);
  /// Undoes what lasted for a time. Letting go of a button or a sensor is no event.
  std::optional<wire::RunEvent::What> end(const Undo& undo, SimTime t);
  void bring_about(const ReadFault& fault, SimTime t);
  void repair(const ReadFault& fault, SimTime t);
  void note_repair(const std::string& part, SimTime t);
  void put_obstacle(const Action& action);
  void clear_obstacle(const std::string& cell);
  /// Throws InputError, with the step's place. Gives its fault, if it is one.
  std::optional<ReadFault> check(const Step& step, const judge::Progress& progress) const;
  /// The arguments begin with the kind.
  ReadFault read_fault(const std::string& part, const std::vector<std::string>& arguments, bool ends) const;

  const Stage stage_;
  BoardFaults board_;
  State state_;
};

}  // namespace robosim::scenario
