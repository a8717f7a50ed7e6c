// A simulation is a clock, a world and agents: robots, each with its own firmware, script, goal and verdict.
// This class alone keeps firmware and world in lockstep.
//
// A tick is [t, t+1 ms):
//   1. The scenario acts at t, and parts schedule their pin edges from the state at t.
//   2. Firmware runs to t+1 ms; its reads inside the tick are extrapolated from the state at t.
//   3. Each motor's command becomes the time average of its pins over the tick.
//   4. The world integrates to t+1 ms; then goal and judge examine it.
// All agents take each step, in the order of their numbers, before the next one begins. So an effect of one
// on another in a tick is visible in the next.
//
// Robots that are so far from all others that no effect can reach another take turns of several ticks. That
// gives the same result and uses the processor's caches better. The order is the same for every executor.
// Nothing here depends on wall time, threads or listeners.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/exec/core/executor.h"
#include "sim/grid/map.h"
#include "sim/judge/goal.h"
#include "sim/judge/outcome.h"
#include "sim/robot/robot.h"
#include "sim/run/step_controller.h"
#include "sim/scenario/scenario.h"

namespace robosim::run {

constexpr SimTime kDefaultLimit = 600 * kSecond;

/// The settings that are fixed before the first tick.
struct Beginning {
  grid::Start start;
  judge::Goal goal;
  std::vector<grid::Station> stations;
  std::vector<std::string> readings;  ///< names, in the order of Sample::readings
  int width = 0, height = 0;          ///< of the map, in cells
  double cell_m = 0.0;                ///< side of a cell
};

/// The state at a moment, for display.
struct Sample {
  SimTime t = 0;
  Pose pose;
  double speed = 0.0;        ///< m/s
  double cross_track = 0.0;  ///< m
  double left = 0.0;         ///< motor command, -1..1
  double right = 0.0;
  std::vector<double> readings;
  std::string at_station;          ///< whose centre the body covers; told to a controller only, "" = none
  std::array<double, 2> wheels{};  ///< m/s, left and right: of the tread, also when it slips
};

/// Receives events of one agent. A listener never changes what happens.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void began(const Beginning&) {}
  virtual void sampled(const Sample&) {}
  virtual void pin_changed(Pin, const PinDrive&, SimTime) {}
  virtual void byte_sent(std::uint8_t, SimTime) {}
  /// Whether the three below are wanted; asked once.
  virtual bool wants_inputs() const { return false; }
  /// What the firmware found on a pin, or an edge that reached an interrupt; see InputWatcher for the order.
  virtual void level_seen(Pin, bool, SimTime) {}
  virtual void volts_seen(Pin, double, SimTime) {}
  virtual void byte_received(std::uint8_t, SimTime) {}
  virtual void happened(const wire::RunEvent&) {}
  /// Whether it minds that, of several robots that have nothing to do with each other, one's pins and bytes
  /// of up to 100 ms are told before another's; samples and events come in the order of time all the same.
  /// Asked once.
  virtual bool minds_turns() const { return true; }
};

/// One robot: its firmware, its start, its goal, and its script.
struct AgentSetup {
  const robot::Description* robot = nullptr;
  exec::Executor* executor = nullptr;  ///< of its own, and of this run only
  std::optional<grid::Start> start;    ///< else the map's
  std::optional<judge::Goal> goal;     ///< else the map's
  std::vector<scenario::Step> scenario;
  Listener* listener = nullptr;  ///< may be null
};

class Scenery;

/// The value of Setup::reached while firmware is loaded and begins.
constexpr SimTime kLoading = -1;

struct Setup {
  const grid::Map* map = nullptr;
  /// Of the map; the first simulation takes it, and the next ones make their own. May be null.
  std::unique_ptr<Scenery>* scenery = nullptr;
  std::vector<AgentSetup> agents;  ///< at least one
  SimTime limit = kDefaultLimit;   ///< simulated
  std::uint64_t seed = 1;
  robot::Profile profile = robot::Profile::typical;
  SimTime samples_every = 0;    ///< a multiple of the tick; 0 = no samples
  bool detect = false;          ///< detectors watch
  bool leaves_rest_out = true;  ///< of robots at rest, without a trace (resting.cpp); tests try it without
  bool takes_turns = true;      ///< of robots that are apart, without a trace; the same
  StepController* controller = nullptr;            ///< drives the run step by step; may be null
  const std::atomic<bool>* interrupted = nullptr;  ///< set by a signal handler; may be null
  /// Is told how far the run has come, for watchdogs: kLoading before any firmware is loaded. May be null.
  std::atomic<SimTime>* reached = nullptr;
  std::atomic<int>* acting = nullptr;  ///< is told whose firmware runs; may be null
};

/// The set-up of one agent is invalid.
class BadAgent : public InputError {
 public:
  BadAgent(const InputError& error, int number) : InputError(error), agent(number) {}
  int agent;       ///< its number
  int other = -1;  ///< the one that it starts on; -1 = it is not about another
};

/// A run that can pause between two ticks, be saved there, and continue from there any number of times.
class Simulation {
 public:
  /// A moment of a simulation: a value, valid as long as the simulation that gave it.
  class Snapshot;

  /// Switches the firmware on. Throws InputError if the set-up, which must outlive this, makes no sense: of
  /// several agents a BadAgent (start off the line or on top of another, unknown parts …).
  explicit Simulation(const Setup& setup);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// How far it has come: a whole number of ticks.
  SimTime now() const;
  /// Whether each agent has its verdict, or the set-up's time is up.
  bool is_over() const;
  /// Goes on until now() is `t` or later, or it is over.
  void run_until(SimTime t);
  /// Adds steps to the end of the first robot's script, between two ticks. Throws InputError as a script
  /// does.
  void add(std::vector<scenario::Step> steps);
  /// Ends the run here: who has no verdict yet has used up the time. Those of all agents, in their order.
  std::vector<judge::Outcome> end();

  /// All that changes: the chips with their boards, robots, world, scripts, goals, judges and trace hashes.
  /// Throws InputError where an executor cannot be saved: on the target host. A debugger and what it has set
  /// are no part of it.
  Snapshot save() const;
  /// Goes on from there as it did after save(), also from behind its end(), or where something was thrown out
  /// of run_until(). What listeners have heard since
  /// is not taken back: they hear it again.
  void restore(const Snapshot& snapshot);

 private:
  struct Inside;
  std::unique_ptr<Inside> in_;
};

/// Runs until each agent has its verdict; returns them in the order of the agents. A finished agent stays
/// where it is, its firmware off, while others continue. Throws InputError if the set-up is invalid (start
/// off the line, unknown parts …).
std::vector<judge::Outcome> simulate(const Setup& setup);

class Simulation::Snapshot {
 private:
  friend class Simulation;
  struct Saved;
  std::shared_ptr<const Saved> saved_;
};

}  // namespace robosim::run
