// Many runs, several at a time, with results in the order in which they were asked for.
//
//   robosim::client::Pool pool(4);
//   pool.run({1000,
//             [&](std::size_t i) { return robosim::client::Task{"host", request_with_seed(i + 1)}; },
//             [&](std::size_t i, robosim::client::Answer answer) { … }});
//
// How many workers there are, and how long each run takes, changes nothing in what is handed over. A worker
// is a runner process, which forks for each run; all of them are waited for in the caller's thread.
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

/// Why there is no result.
struct Failure {
  enum class Kind {
    input,     ///< what was asked for is wrong (InputError)
    tool,      ///< a tool is missing (ToolMissing)
    internal,  ///< the runner died, or met a fault of its own (RunnerError)
  };
  Kind kind = Kind::internal;
  std::string message;
};

using Answer = std::variant<wire::RunResult, Failure>;

/// What a pool works through: runs 0 to count - 1.
struct Batch {
  std::size_t count = 0;
  std::function<Task(std::size_t)> task;
  /// Called for each run in ascending order. What it throws ends the batch and passes through.
  std::function<void(std::size_t, Answer)> answered;
  /// Whether a run is (still) wanted; may be empty. Asked before a run begins, which may be too early to
  /// know, and, after the answers of all runs before it, whether to hand over its own. So a run beyond the
  /// point where enough is known is dropped, even if it was made.
  std::function<bool(std::size_t)> wanted;
};

class Pool {
 public:
  /// How a worker's runner is started; the default is Runner(target).
  using Start = std::function<Runner(const std::string& target)>;

  explicit Pool(std::size_t workers, Start start = {});
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// False if it was interrupted: then what was finished has been handed over, still in ascending order, and
  /// the other runs are missing.
  bool run(const Batch& batch);

  /// Ends the batch, and any later one; runs that have not finished are killed. May be called from a signal
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
