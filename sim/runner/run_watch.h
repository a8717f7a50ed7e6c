// Ends a run that never would. It observes from outside: native firmware may turn off anything in its own
// process, by mistake or not.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>

#include "hal/board/sim_time.h"
#include "sim/runner/shared.h"

namespace robosim::runner {

/// Firmware that takes longer for one tick (usually a microsecond for each robot), or for loading, will never
/// end it. It loops where nothing is instrumented, such as in a library function with an unterminated string,
/// or it sleeps.
constexpr int kLongestTick_s = 5;    ///< of processor time
constexpr int kLongestSleep_s = 30;  ///< of wall time, almost without processor time
/// A whole run may take this processor time since the loading of its firmware, plus the simulated time.
constexpr int kLongestRun_s = 60;

/// Runs are watched one at a time: the shared memory is reused from earlier runs, which have ended. Native
/// firmware may have written anything there.
class RunWatch {
 public:
  /// Throws std::system_error.
  RunWatch();

  // Called in the run's process.

  /// Receives how far the run has come.
  std::atomic<SimTime>& reached() { return state_.reached; }
  /// Receives whose firmware runs.
  std::atomic<int>& acting() { return state_.acting; }
  void wait_for_client(bool waits) { state_.waits = waits; }
  /// Notes that firmware comes next. Firmware cannot take that back: the note leaves the process's memory.
  void close() const;

  // Called in its parent.

  struct Limits {
    SimTime until = 0;      ///< simulated, upper limit
    double share = 1.0;     ///< processor time that it may take, per simulated time
    bool may_wait = false;  ///< for its client
  };
  void follow(pid_t run, const Limits& limits);
  /// Notes that it has sent a message.
  void heard() { silent_us_ = 0; }
  enum class Found { nothing, loops, sleeps, exhausts };
  /// Checks the run. Call it repeatedly.
  Found look() { return look(read()); }
  /// Returns how far the run has come, within its limits.
  SimTime time() const;

  /// The system's data on the run's process.
  struct Reading {
    std::int64_t processor_ns = 0;
    std::int64_t wall_us = 0;
    bool is_excused = false;  ///< by a debugger, or for want of a processor; only checked in a long silence
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
  bool has_begun_ = false;  ///< to load firmware; once it has, whatever it writes
  int seen_acting_ = 0;
  std::int64_t begun_ns_ = 0;      ///< of processor time, before any firmware was loaded
  std::int64_t processor_ns_ = 0;  ///< at its last progress
  Reading looked_{0, -1, false};   ///< at the last look
  std::int64_t silent_us_ = 0;     ///< of wall time without progress and work
};

}  // namespace robosim::runner
