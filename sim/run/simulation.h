// A simulation consists of a clock, a world and agents. An agent is a robot with its own firmware, script,
// goal and verdict. Only the class Simulation keeps firmware and world in lockstep.
//
// A tick is [t, t+1 ms):
//   1. The scenario acts at t, and parts schedule their pin edges from the state at t.
//   2. Firmware runs to t+1 ms; the inputs that it reads in the tick are extrapolated from the state at t.
//   3. Each motor's command becomes the time average of its pins over the tick.
//   4. The world integrates to t+1 ms; then goal and judge examine it.
// All agents perform one of these steps, in the order of their numbers, before the next step begins. An
// agent's effect on another agent therefore becomes visible in the next tick.
//
// A robot that is too far from all others to affect them runs several ticks in one turn. This uses the
// processor's caches better, and does not change the result. The order of turns is the same for every
// executor, and does not depend on wall time, threads or listeners.
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
#include "sim/judge/goal.h"
#include "sim/judge/outcome.h"
#include "sim/map/map.h"
#include "sim/robot/robot.h"
#include "sim/run/scenario/scenario.h"
#include "sim/run/step_controller.h"

namespace robosim::run {

constexpr SimTime kDefaultLimit = 600 * kSecond;

/// The settings that are fixed before the first tick.
struct Beginning {
  map::Start start;
  judge::Goal goal;
  std::vector<map::Station> stations;
  std::vector<std::string> readings;  ///< names of parts, in the order of Sample::readings
  int width = 0, height = 0;          ///< size of the map, in cells
  double cell_m = 0.0;                ///< side of a cell
};

/// The state at a time, for display.
struct Sample {
  SimTime t = 0;
  Pose pose;
  double speed = 0.0;        ///< m/s
  double cross_track = 0.0;  ///< m
  double left = 0.0;         ///< motor command, -1..1
  double right = 0.0;
  std::vector<double> readings;
  std::string at_station;          ///< station whose centre the body covers, or ""; for controllers only
  std::array<double, 2> wheels{};  ///< m/s, left and right: speed of the tread, also during slip
};

/// Receives events of one agent. A listener never affects the run.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void began(const Beginning&) {}
  virtual void sampled(const Sample&) {}
  virtual void pin_changed(Pin, const PinDrive&, SimTime) {}
  virtual void byte_sent(std::uint8_t, SimTime) {}
  /// Returns whether the listener needs the three functions below. Called once.
  virtual bool wants_inputs() const { return false; }
  /// Reports a level that the firmware read on a pin, or an edge that reached an interrupt. InputWatcher
  /// describes the order of these reports.
  virtual void level_seen(Pin, bool, SimTime) {}
  virtual void volts_seen(Pin, double, SimTime) {}
  virtual void byte_received(std::uint8_t, SimTime) {}
  virtual void happened(const result::RunEvent&) {}
  /// Returns whether the order of reports of independent robots matters. If not, up to 100 ms of one robot's
  /// pin changes and bytes may be reported before those of another robot. Samples and events are always
  /// sorted by time. Called once.
  virtual bool minds_turns() const { return true; }
};

/// One robot: its firmware, its start, its goal, and its script.
struct AgentSetup {
  const robot::Description* robot = nullptr;
  exec::Executor* executor = nullptr;  ///< not shared with any other run or agent
  std::optional<map::Start> start;     ///< if empty, the map's start is used
  std::optional<judge::Goal> goal;     ///< if empty, the map's goal is used
  std::vector<scenario::Step> scenario;
  Listener* listener = nullptr;  ///< may be null
};

class PreparedMap;

/// The value of Setup::reached while firmware is loaded and starts.
constexpr SimTime kLoading = -1;

struct Setup {
  const map::Map* map = nullptr;
  /// The prepared map, or null. The first simulation takes ownership of the map; later simulations prepare
  /// their own.
  std::unique_ptr<PreparedMap>* prepared_map = nullptr;
  std::vector<AgentSetup> agents;  ///< at least one
  SimTime limit = kDefaultLimit;   ///< simulated time
  std::uint64_t seed = 1;
  robot::Profile profile = robot::Profile::typical;
  SimTime samples_every = 0;    ///< a multiple of the tick; 0 = no samples
  bool detect = false;          ///< turns on detectors
  bool leaves_rest_out = true;  ///< skips repeated work for robots at rest, with equal results
                                ///< (rest_optimization.cpp); tests turn it off
  bool takes_turns = true;      ///< allows turns of several ticks, with equal results; tests turn it off
  StepController* controller = nullptr;            ///< drives the run step by step; may be null
  const std::atomic<bool>* interrupted = nullptr;  ///< set by a signal handler; may be null
  /// Receives the time that the run has reached, for watchdogs. Set to kLoading before any firmware is
  /// loaded. May be null.
  std::atomic<SimTime>* reached = nullptr;
  std::atomic<int>* acting = nullptr;  ///< receives the number of the agent whose firmware runs; may be null
};

/// Reports an invalid set-up of one agent.
class BadAgent : public InputError {
 public:
  BadAgent(const InputError& error, int number) : InputError(error), agent(number) {}
  int agent;       ///< number of the agent
  int other = -1;  ///< number of the agent that occupies its start; -1 = no other agent is involved
};

/// A run that can pause between two ticks, be saved there, and continue from there any number of times.
class Simulation {
 public:
  /// The saved state of a simulation at a time. It can be copied, and is valid as long as the simulation that
  /// saved it exists.
  class Snapshot;

  /// Switches the firmware on. The set-up must outlive this object. Throws InputError if the set-up is
  /// invalid (start off the line or on top of another robot, unknown parts …). With several agents, the error
  /// is a BadAgent.
  explicit Simulation(const Setup& setup);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Returns the time that the run has reached: a whole number of ticks.
  SimTime now() const;
  /// Returns whether each agent has its verdict, or the set-up's time limit is reached.
  bool is_over() const;
  /// Continues until now() is at least `t`, or the run is over.
  void run_until(SimTime t);
  /// Adds steps to the end of the first robot's script, between two ticks. Throws InputError for the same
  /// errors as a script.
  void add(std::vector<scenario::Step> steps);
  /// Ends the run. Agents without a verdict get the verdict of a run whose time is up. Returns the outcomes
  /// of all agents, in the order of their numbers.
  std::vector<judge::Outcome> end();

  /// Saves all changing state: chips with their boards, robots, world, scripts, goals, judges and trace
  /// hashes. Throws InputError if an executor cannot be saved, as on the target host. A debugger and its
  /// settings are not included.
  Snapshot save() const;
  /// Restores a snapshot, even after end() or an exception from run_until(). Listeners then receive all
  /// reports since the snapshot again.
  void restore(const Snapshot& snapshot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Runs until each agent has its verdict. Returns the outcomes in the order of the agents. A finished agent
/// stays where it is, with its firmware off, while others continue. Throws InputError if the set-up is
/// invalid (start off the line, unknown parts …).
std::vector<judge::Outcome> simulate(const Setup& setup);

class Simulation::Snapshot {
 private:
  friend class Simulation;
  struct Saved;
  std::shared_ptr<const Saved> saved_;
};

}  // namespace robosim::run
