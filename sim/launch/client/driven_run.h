// Controls a run step by step. The run pauses at t = 0, at a time that the caller chooses, and when a stop
// condition occurs. During a pause, the caller can read the run's state and add lines of the script language
// (docs/reference/scripts.md).
//
//   request.samples_every_ns = …;
//   client::DrivenRun run(runner, request, on_event);
//   run.act("press start 100ms");
//   if (run.go_on(5'000'000'000, {result::Stop::serial("ready")})) …   // pauses at 5 s, or earlier
//   const result::RunResult result = run.end();
//
// A second run whose request contains run.script() as its script has the same trace.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/launch/client/runner.h"

namespace robosim::client {

class DrivenRun {
 public:
  /// Starts a run on `runner`, which is busy until the run is over. This class calls `on_event` for each
  /// event of the run; `on_event` must not call this class. Throws the exceptions of Runner::run().
  DrivenRun(Runner& runner, wire::RunRequest request, wire::OnEvent on_event = {});
  /// Ends the run if it is still in progress.
  ~DrivenRun();
  DrivenRun(const DrivenRun&) = delete;
  DrivenRun& operator=(const DrivenRun&) = delete;

  /// Returns the state at the current pause. After the end of the run, returns the state at the last pause.
  const wire::Paused& state() const { return state_; }
  /// Runs actions of the script language, one per line. An action is written without its time, as in
  /// `press start 100ms`. The actions take effect when the run continues. Throws InputError, without effect,
  /// if an action is invalid.
  void act(const std::string& lines, std::size_t agent = 0);
  /// Returns the content of the chip's EEPROM.
  std::vector<std::uint8_t> eeprom(std::size_t agent = 0);
  /// Continues the run until the simulated time `to_ns`, a stop condition, or the verdict of a robot. Returns
  /// false after the verdict of the last robot: the run is then over. Throws InputError, without effect, if a
  /// stop condition is invalid.
  bool go_on(std::int64_t to_ns, const std::vector<result::Stop>& stops = {});
  /// Runs to the verdict. With several robots, runs to the verdict of the last robot.
  const result::RunResult& finish();
  /// Ends a run in progress at its present time, with the verdict `interrupted`. Returns the result.
  const result::RunResult& end();

  bool over() const { return result_.has_value(); }
  /// Returns the result; call it only when the run is over.
  const result::RunResult& result() const { return *result_; }
  /// Returns a robot's script: the script in the request, followed by all lines of act() with their times.
  const std::string& script(std::size_t agent = 0) const { return scripts_[agent]; }

 private:
  wire::Line ask(const wire::DrivenRequest& request);
  bool take(wire::Line line);

  Runner& runner_;
  wire::OnEvent on_event_;
  long long id_ = 0;
  std::vector<std::string> scripts_;  ///< one script for each robot
  wire::Paused state_;
  std::optional<result::RunResult> result_;
};

}  // namespace robosim::client
