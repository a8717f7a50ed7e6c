// Starts a runner and talks to it.
//
//   robosim::client::Runner runner("host");
//   const auto robot = runner.describe_robot("uno5");
//   robosim::client::RunRequest request;
//   request.image = …; request.map = …; request.robot = "uno5";
//   const auto result = runner.run(request);        // result.verdict == "reached"
//
// One runner serves any number of runs, one after the other; use several runners for runs side by side.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/batch.h"
#include "sim/wire/messages.h"
#include "sim/wire/protocol.h"

namespace robosim::client {

/// The targets that this version has runners for: "host", "avr", "stm32". A build without an emulator's
/// package lacks its runner all the same: Runner then throws ToolMissing.
const std::vector<std::string>& available_targets();

class Process;

class Runner {
 public:
  /// Starts the runner of a target. Throws ToolMissing if its program is not there, RunnerError if it does
  /// not say hello or speaks another version of the protocol.
  explicit Runner(const std::string& target);
  /// Starts the given program instead (for tests).
  static Runner from_program(const std::string& path);
  ~Runner();
  Runner(Runner&&) noexcept;
  Runner& operator=(Runner&&) noexcept;

  const wire::Hello& hello() const { return hello_; }

  /// A stock robot's name, or a path; `full`: with RobotInfo::text. Throws InputError.
  wire::RobotInfo describe_robot(const std::string& robot, bool full = false);

  /// Runs to the verdict. Throws InputError for bad input, ToolMissing, and RunnerError when the runner dies
  /// without an answer, breaks the protocol or meets a fault of its own; after a RunnerError this runner is
  /// of no more use. What `on_event` throws ends the runner and passes through.
  wire::RunResult run(const wire::RunRequest& request, const wire::OnEvent& on_event = {});

  /// run() in two parts, for those who wait for several runners at once: begin() asks, and take() has the
  /// result if it has come, without waiting for it; it throws as run() does. In between descriptor() is
  /// readable, as poll(2) has it, whenever take() has something to do.
  void begin(const wire::RunRequest& request);
  std::optional<wire::RunResult> take(const wire::OnEvent& on_event = {});
  int descriptor() const noexcept;

  /// From now on the runner gets ahead of `on_event` by a few kilobytes of events at most, for those who
  /// watch: what is interrupted then is what is seen. Costs speed.
  void keep_close() noexcept;

  /// Ends the current run with the verdict `interrupted`; run() still returns, unless nothing comes from the
  /// runner for two seconds of wall time: then it is killed. May be called from a signal handler or from
  /// within `on_event`.
  void interrupt() noexcept;
  /// Ends the runner at once; run() throws RunnerError. May be called from a signal handler.
  void kill() noexcept;

 private:
  friend class DrivenRun;
  struct Program {
    std::string path;
  };
  explicit Runner(const Program& program);
  [[noreturn]] void fail_silent();
  /// The answer to the last request, no event and no error; nothing if it has not come and `wait` is false.
  std::optional<wire::Line> answer(bool wait, const wire::OnEvent& on_event);
  template <typename Answer>
  std::optional<Answer> take(bool wait, const wire::OnEvent& on_event);
  void read_batch(std::string_view bytes, const wire::OnEvent& on_event);

  std::string name_;
  std::unique_ptr<Process> process_;
  wire::Hello hello_;
  long long last_id_ = 0;
  wire::BatchReader batches_{{}};  ///< of the run that was asked for last
  bool batch_is_damaged_ = false;  ///< one of that run's; what came later is not read
};

}  // namespace robosim::client
