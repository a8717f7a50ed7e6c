// Ends a run that never will. It is looked at from outside: firmware that is code of this machine may switch
// off whatever its own process has, by mistake or not.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>

#include "hal/board/sim_time.h"
#include "sim/runner/shared.h"

namespace robosim::runner {

/// Firmware that takes so long for one tick (usually a microsecond; of several robots, each), or for being
/// loaded, will never end it: it loops where nothing is instrumented, such as in a library function that was
/// handed an endless string, or it sleeps.
constexpr int kLongestTick_s = 5;    ///< of processor time
constexpr int kLongestSleep_s = 30;  ///< of wall time, in which it hardly works
/// A whole run may take this processor time from the loading of its firmware on, and the simulated time on
/// top.
constexpr int kLongestRun_s = 60;

/// One at a time: what it shares with a run's process has been shared with those before, which have ended.
/// Firmware that is code of this machine may have written anything there.
class RunWatch {
 public:
  /// Throws std::system_error.
  RunWatch();

  // In the run's process.

  /// Is told how far the run has come.
  std::atomic<SimTime>& reached() { return state_.reached; }
  /// And whose firmware runs.
  std::atomic<int>& acting() { return state_.acting; }
  void wait_for_client(bool waits) { state_.waits = waits; }

  // In its parent.

  struct Limits {
    SimTime until = 0;      ///< simulated, at most
    double share = 1.0;     ///< of the simulated time that it may take of a processor
    bool may_wait = false;  ///< for its client
  };
  void follow(pid_t run, const Limits& limits);
  /// It has said something.
  void heard() { silent_us_ = 0; }
  enum class Found { nothing, loops, sleeps, exhausts };
  /// To be asked again and again.
  Found look() { return look(read()); }
  /// How far the run has come, within its limits.
  SimTime time() const;

  /// What the system says of the run's process.
  struct Reading {
    std::int64_t processor_ns = 0;
    std::int64_t wall_us = 0;
    bool is_debugged = false;  ///< halted by a debugger; only asked in a long silence
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
  Reading read() const;

  State& state_;
  pid_t run_ = -1;
  Limits limits_;
  SimTime seen_ = kNotBegun;
  int seen_acting_ = 0;
  std::int64_t begun_ns_ = 0;      ///< of processor time, before any firmware was loaded
  std::int64_t processor_ns_ = 0;  ///< when it last came further
  Reading looked_{0, -1, false};   ///< at the last look
  std::int64_t silent_us_ = 0;     ///< of wall time in which it neither came further nor worked
};

}  // namespace robosim::runner
