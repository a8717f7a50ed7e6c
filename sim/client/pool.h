// Makes many runs, several at a time, and returns results in the order of the requests.
//
//   robosim::client::Pool pool(4);
//   pool.run({1000,
//             [&](std::size_t i) { return robosim::client::Task{"host", request_with_seed(i + 1)}; },
//             [&](std::size_t i, robosim::client::Answer answer) { … }});
//
// The number of workers and the duration of runs do not affect the results. A worker is a runner process,
// which forks for each run. The caller's thread waits for all of them.
#pragma once

#include <signal.h>

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/client/runner.h"
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
    internal,  ///< the runner died, or has an internal fault (RunnerError)
  };
  Kind kind = Kind::internal;
  std::string message;
};

using Answer = std::variant<wire::RunResult, Failure>;

/// The work of a pool: runs 0 to count - 1.
struct Batch {
  std::size_t count = 0;
  std::function<Task(std::size_t)> task;
  /// Called for each run in ascending order. An exception ends the batch and is passed on.
  std::function<void(std::size_t, Answer)> answered;
  /// Returns whether a run is (still) wanted; may be empty. Called before a run begins, which may be too
  /// early to know. Called again, after the answers of all earlier runs, before its own is passed on. So runs
  /// after the deciding one are dropped, even if they were made.
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

  /// Makes the runs. Returns false if it was interrupted: then finished runs have been passed on, still in
  /// ascending order, and the others are missing.
  bool run(const Batch& batch);

  /// Ends the batch, and any later one; unfinished runs are killed. May be called from a signal handler.
  void interrupt() noexcept { interrupted_ = 1; }

 private:
  struct Worker;
  struct Work;
  std::vector<Worker> workers_;
  Start start_;
  volatile sig_atomic_t interrupted_ = 0;
};

}  // namespace robosim::client
