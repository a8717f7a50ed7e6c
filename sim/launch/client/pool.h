// Executes many runs, several at a time, and returns results in the order of the requests.
//
//   robosim::client::Pool pool(4);
//   pool.run({1000,
//             [&](std::size_t i) { return robosim::client::Task{"host", request_with_seed(i + 1)}; },
//             [&](std::size_t i, robosim::client::Answer answer) { … }});
//
// The number of workers and the duration of runs do not affect the results. A worker is a runner process,
// which forks for each run. The caller's thread waits for all workers.
#pragma once

#include <signal.h>

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/launch/client/runner.h"
#include "sim/wire/messages.h"

namespace robosim::client {

/// A run and the target that executes it.
struct Task {
  std::string target;
  wire::RunRequest request;
};

/// The reason for a missing result.
struct Failure {
  enum class Kind {
    input,     ///< the request is invalid (InputError)
    tool,      ///< a tool is missing (ToolMissing)
    internal,  ///< the runner has died, or has an internal fault (RunnerError)
  };
  Kind kind = Kind::internal;
  std::string message;
};

using Answer = std::variant<result::RunResult, Failure>;

/// The work for a pool: runs 0 to count - 1.
struct Batch {
  std::size_t count = 0;
  std::function<Task(std::size_t)> task;
  /// Receives the answer of each run, in ascending order of the run numbers. If this function throws, the
  /// batch ends and Pool::run() throws the exception.
  std::function<void(std::size_t, Answer)> answered;
  /// Returns whether the result of a run is still needed; may be empty. Pool calls this function twice:
  ///   - before the run begins, when earlier runs may still be in progress;
  ///   - before it passes the run's answer to `answered`, after the answers of all earlier runs.
  /// An unneeded run is dropped, even if it was executed.
  std::function<bool(std::size_t)> wanted;
};

class Pool {
 public:
  /// Starts a worker's runner; the default is Runner(target).
  using Start = std::function<Runner(const std::string& target)>;

  explicit Pool(std::size_t workers, Start start = {});
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Executes the runs. Returns false if the pool was interrupted. In this case, only the answers of finished
  /// runs have been passed to `answered`, in ascending order.
  bool run(const Batch& batch);

  /// Ends the current batch and every later batch. Kills unfinished runs. May be called from a signal
  /// handler.
  void interrupt() noexcept { interrupted_ = 1; }

 private:
  struct Worker;
  struct Work;
  std::vector<Worker> workers_;
  Start start_;
  volatile sig_atomic_t interrupted_ = 0;
};

}  // namespace robosim::client
