// Ends a run that never will. It is looked at from outside: firmware that is code of this machine may switch
// off whatever its own process has, by mistake or not.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>

#include "hal/board/sim_time.h"
#include "sim/runner/shared.h"

namespace robosim::runner {

/// Firmware that takes so long for one tick (usually a microsecond; of several robots, each) will never end
/// it: it loops where nothing is instrumented, such as in a library function that was handed an endless
/// string, or it sleeps.
constexpr int kLongestTick_s = 5;    ///< of processor time
constexpr int kLongestSleep_s = 30;  ///< of wall time

/// One at a time: what it shares with a run's process has been shared with those before, which have ended.
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

  void follow(pid_t run);
  /// It has said something.
  void heard();
  enum class Found { nothing, loops, sleeps };
  /// To be asked again and again.
  Found look();

 private:
  static constexpr SimTime kNotBegun = -2;
  struct State {
    std::atomic<SimTime> reached{kNotBegun};
    std::atomic<int> acting{0};
    std::atomic<bool> waits{false};
  };
  static State& state();
  bool is_stopped() const;

  State& state_;
  pid_t run_ = -1;
  SimTime seen_ = kNotBegun;
  int seen_acting_ = 0;
  std::int64_t processor_ns_ = 0, wall_us_ = 0;
};

}  // namespace robosim::runner
