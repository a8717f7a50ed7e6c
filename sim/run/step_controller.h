// Drives a run step by step, for tests and other clients that react to the run's state. The run pauses at the
// beginning of a tick. Its controller then examines the run, acts on it, and continues it until a chosen
// event or time. A script with the controller's lines, and with the times of these lines, produces the same
// trace as the driven run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/vec.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/outcome.h"
#include "sim/result/stop.h"
#include "sim/run/scenario/scenario.h"

namespace robosim::run {

struct Sample;

using result::Stop;

/// The controller's next request: the run continues until a time, or until a stop condition is met. With
/// `end`, the run ends at once instead, with the verdict `interrupted`.
struct Leg {
  SimTime until = kNever;
  std::vector<Stop> stops;
  bool end = false;
};

/// An agent's state at the beginning of a tick.
struct State {
  SimTime t = 0;
  int stop = -1;  ///< index of the leg's stop that was met; -1 = none was met
  /// Maximum of the cross-track error in the leg, over all ticks, with its time and place.
  double worst_cross_track = 0.0;  ///< m
  SimTime worst_t = 0;
  Vec2 worst_at;  ///< centre of the axle, m
  bool powered = true;
  bool driven = false;           ///< a motor is commanded
  std::size_t serial_bytes = 0;  ///< number of bytes sent by the firmware so far
  judge::Metrics metrics;
  std::optional<exec::Resources> resources;  ///< on an emulated chip only
};

/// A paused run.
class Standstill {
 public:
  virtual int agent_count() const = 0;
  virtual const State& state(int agent = 0) const = 0;
  virtual const Sample& sample(int agent = 0) const = 0;
  /// Returns the outcome of an agent that has its verdict while others continue; null for other agents.
  virtual const judge::Outcome* outcome(int agent = 0) const = 0;
  /// Returns the entire EEPROM of the board.
  virtual std::vector<std::uint8_t> eeprom(int agent = 0) const = 0;
  /// Adds steps to an agent's script. Steps that are due take effect as soon as the run continues. If a name
  /// is unknown, throws InputError and adds no steps.
  virtual void add(std::vector<scenario::Step> steps, int agent = 0) = 0;
  /// Throws InputError if a stop of the leg is invalid in this run.
  virtual void check(const Leg& leg) const = 0;

 protected:
  ~Standstill() = default;
};

class StepController {
 public:
  virtual ~StepController() = default;
  /// Returns the next leg. Called at t = 0 and after each leg. A leg also ends when one robot gets its
  /// verdict while others continue.
  virtual Leg next(Standstill& standstill) = 0;
};

}  // namespace robosim::run
