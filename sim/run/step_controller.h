// Drives a run step by step, for tests and other clients that react to its state. The run pauses at the
// beginning of a tick, its controller examines it and acts, and then continues it until something happens. A
// script with the same lines at the same times gives the same trace.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/vec.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/outcome.h"
#include "sim/scenario/scenario.h"
#include "sim/wire/driven.h"

namespace robosim::run {

struct Sample;

using wire::Stop;

/// The controller's next request: continue until the first of these, or to the end at once (`interrupted`).
struct Leg {
  SimTime until = kNever;
  std::vector<Stop> stops;
  bool end = false;
};

/// An agent's state at the beginning of a tick.
struct State {
  SimTime t = 0;
  int stop = -1;  ///< index of the leg's stop that was met; -1 = none, its time is up
  /// For the leg: when and where the cross-track error was the largest. Every tick counts.
  double worst_cross_track = 0.0;  ///< m
  SimTime worst_t = 0;
  Vec2 worst_at;  ///< the axle's centre, m
  bool powered = true;
  bool driven = false;           ///< a motor is commanded
  std::size_t serial_bytes = 0;  ///< sent by the firmware so far
  judge::Metrics metrics;
  std::optional<exec::Resources> resources;  ///< of a chip
};

/// A paused run.
class Standstill {
 public:
  virtual int agent_count() const = 0;
  virtual const State& state(int agent = 0) const = 0;
  virtual const Sample& sample(int agent = 0) const = 0;
  /// Returns the outcome of an agent that has its verdict while others continue; else null.
  virtual const judge::Outcome* outcome(int agent = 0) const = 0;
  /// Returns the whole non-volatile memory of the firmware.
  virtual std::vector<std::uint8_t> eeprom(int agent = 0) const = 0;
  /// Adds steps to an agent's script; steps that are due now run as soon as the run continues. Throws
  /// InputError, and adds none, for unknown names.
  virtual void add(std::vector<scenario::Step> steps, int agent = 0) = 0;
  /// Throws InputError if a stop is invalid here.
  virtual void check(const Leg& leg) const = 0;

 protected:
  ~Standstill() = default;
};

class StepController {
 public:
  virtual ~StepController() = default;
  /// Called at t = 0 and whenever a leg has ended, also by the verdict of one robot while others continue.
  virtual Leg next(Standstill& standstill) = 0;
};

}  // namespace robosim::run
