// Starts a runner, the process that simulates the runs of a target, and communicates with it.
//
//   robosim::client::Runner runner("host");
//   const auto robot = runner.describe_robot("uno5");
//   robosim::wire::RunRequest request;
//   request.image = …; request.map = …; request.robot = "uno5";
//   const auto result = runner.run(request);        // result.verdict == "reached"
//
// One runner executes any number of runs in sequence. Use several runners for parallel runs.
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

/// Returns the targets for which this version has runners: "host", "avr", "stm32". A build lacks a target's
/// runner if the package of the target's emulator is missing. In this case, Runner throws ToolMissing.
const std::vector<std::string>& available_targets();

class Process;

class Runner {
 public:
  /// Starts the runner of a target. Throws ToolMissing if its program is missing. Throws RunnerError if the
  /// runner does not send its first message or has another version of the protocol.
  explicit Runner(const std::string& target);
  /// Starts the given program instead of a target's runner (for tests).
  static Runner from_program(const std::string& path);
  ~Runner();
  Runner(Runner&&) noexcept;
  Runner& operator=(Runner&&) noexcept;

  const wire::Hello& hello() const { return hello_; }

  /// Describes a robot. `robot` is the name of a stock robot, or the path of any other robot. `full` adds
  /// RobotInfo::text. Throws InputError.
  wire::RobotInfo describe_robot(const std::string& robot, bool full = false);

  /// Runs to the verdict. Throws InputError for invalid input, and ToolMissing. Throws RunnerError if the
  /// runner dies without an answer, breaks the protocol or has an internal fault; the runner is then
  /// unusable. An exception from `on_event` ends the runner and is passed on.
  result::RunResult run(const wire::RunRequest& request, const wire::OnEvent& on_event = {});

  /// Splits run() into two parts, so that a caller can wait for several runners at once. begin() sends the
  /// request. take() returns the result, or nothing if the result has not arrived; it does not wait. take()
  /// throws the exceptions of run(). Between begin() and the result, poll(2) reports descriptor() as readable
  /// whenever take() has work to do.
  void begin(const wire::RunRequest& request);
  std::optional<result::RunResult> take(const wire::OnEvent& on_event = {});
  int descriptor() const noexcept;

  /// From now on, stops the runner whenever it is a few kilobytes of events ahead of `on_event`. Viewers need
  /// this limit, so that an interrupt takes effect near the visible state. The limit slows the run down.
  void keep_close() noexcept;

  /// Ends the current run with the verdict `interrupted`; run() still returns the result. If the runner is
  /// silent for two seconds of wall time, however, it is killed, and run() throws wire::Unstoppable. May be
  /// called from a signal handler or from `on_event`.
  void interrupt() noexcept;
  /// Kills the runner; run() throws RunnerError. May be called from a signal handler.
  void kill() noexcept;

 private:
  friend class DrivenRun;
  struct Program {
    std::string path;
  };
  explicit Runner(const Program& program);
  [[noreturn]] void fail_silent();
  /// Returns the answer to the last request. Passes events to `on_event`, and throws errors. Returns nothing
  /// if the answer has not arrived and `wait` is false.
  std::optional<wire::Line> answer(bool wait, const wire::OnEvent& on_event);
  template <typename Answer>
  std::optional<Answer> take(bool wait, const wire::OnEvent& on_event);
  void read_batch(std::string_view bytes, const wire::OnEvent& on_event);

  std::string name_;
  std::unique_ptr<Process> process_;
  wire::Hello hello_;
  long long last_id_ = 0;
  wire::BatchReader batches_{{}};  ///< reader for the last requested run
  bool batch_is_damaged_ = false;  ///< true: skips further batches of the last requested run
};

}  // namespace robosim::client
