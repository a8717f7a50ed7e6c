// Handles Ctrl-C, SIGTERM and SIGHUP during a run.
#pragma once

#include <signal.h>

#include <array>
#include <cstddef>

#include "sim/launch/client/pool.h"
#include "sim/launch/client/runner.h"

namespace robosim::client {

/// Makes SIGINT, SIGTERM and SIGHUP end the runner's current run with the verdict `interrupted`. A second
/// signal kills the runner. A pool ends its batch at the first signal. The handlers are active from
/// construction to destruction. Only one object may exist at a time.
class Interrupts {
 public:
  explicit Interrupts(Runner& runner);
  explicit Interrupts(Pool& pool);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// Returns the number of signals that have arrived since construction.
  static int count();
  /// Returns the number of the first signal, such as SIGINT, or 0 if no signal has arrived.
  static int signal();

 private:
  void catch_signals();

  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_;
};

/// Executes the runs of a batch, at most `jobs` at a time. Returns false if the user interrupted them. Throws
/// the exceptions of Pool::run().
bool make_runs(const Batch& batch, std::size_t jobs);

}  // namespace robosim::client
