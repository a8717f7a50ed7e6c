// Detects a run that would never end. Watches the run from another process, because native firmware may turn
// off anything in its own process, intentionally or not.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>

#include "hal/board/sim_time.h"
#include "sim/runner/shared.h"

namespace robosim::runner {

/// Limits for one tick, and for loading the firmware. A tick usually takes a microsecond for each robot. If
/// firmware exceeds a limit, it will never finish. It either sleeps, or loops in code that is not
/// instrumented, such as a library function with an unterminated string.
constexpr int kLongestTick_s = 5;    ///< processor time
constexpr int kLongestSleep_s = 30;  ///< wall time with almost no processor time
/// Limit of a whole run's processor time, from the loading of its firmware on, in addition to the simulated
/// time.
constexpr int kLongestRun_s = 60;

/// Watches one run at a time. Reuses the shared memory of earlier runs, which have ended; their native
/// firmware may have written anything to it.
class RunWatch {
 public:
  /// Prepares the shared memory for a new run. Throws std::system_error.
  RunWatch();

  // Functions for the run's process.

  /// Returns the variable to which the run writes the time that it has reached.
  std::atomic<SimTime>& reached() { return state_.reached; }
  /// Returns the variable to which the run writes the number of the robot whose firmware runs.
  std::atomic<int>& acting() { return state_.acting; }
  void wait_for_client(bool waits) { state_.waits = waits; }
  /// Records that firmware runs next. Firmware cannot undo this, since the record leaves the process's
  /// memory.
  void close() const;

  // Functions for the parent process.

  struct Limits {
    SimTime until = 0;      ///< upper limit of the simulated time
    double share = 1.0;     ///< allowed processor time, as a multiple of the simulated time
    bool may_wait = false;  ///< the run may wait for its client
  };
  void follow(pid_t run, const Limits& limits);
  /// Records that the run has sent a message.
  void heard() { silent_us_ = 0; }
  enum class Found { nothing, loops, sleeps, exhausts };
  /// Checks the run. Must be called repeatedly.
  Found look() { return look(read()); }
  /// Returns the time that the run has reached, clamped to its limits.
  SimTime time() const;

  /// The operating system's data about the run's process.
  struct Reading {
    std::int64_t processor_ns = 0;
    std::int64_t wall_us = 0;
    bool is_excused = false;  ///< halted by a debugger or awaits a processor; checked only in long silence
  };
  Found look(const Reading& now);

 private:
  static constexpr SimTime kNotBegun = -2;
  struct State {
    std::atomic<SimTime> reached{kNotBegun};
    std::atomic<int> acting{0};
    std::atomic<bool> waits{false};
  };
  static State& state();
  static const Shared<std::atomic<bool>>& closed();
  Reading read() const;

  State& state_;
  pid_t run_ = -1;
  Limits limits_;
  SimTime seen_ = kNotBegun;
  bool has_begun_ = false;  ///< loading of firmware has begun; stays true, whatever the firmware writes
  int seen_acting_ = 0;
  std::int64_t begun_ns_ = 0;      ///< processor time before any firmware was loaded
  std::int64_t processor_ns_ = 0;  ///< processor time at the last progress
  Reading looked_{0, -1, false};   ///< reading at the last check
  std::int64_t silent_us_ = 0;     ///< wall time without progress minus kBusyMachine times the processor time
};

}  // namespace robosim::runner
