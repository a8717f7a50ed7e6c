// Controls a run step by step. The run pauses at t = 0 and at every stop. During a pause, the run's state is
// available, and lines of the scenario language can be run.
//
//   request.samples_every_ns = …;
//   client::DrivenRun run(runner, request, on_event);
//   run.act("press start 100ms");
//   if (run.go_on(5'000'000'000, {client::Stop::serial("ready")})) …   // pauses at 5 s, or earlier
//   const client::RunResult result = run.end();
//
// A later run with run.script() as its script has the same trace.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/launch/client/runner.h"

namespace robosim::client {

class DrivenRun {
 public:
  /// Starts a run on a runner, which is busy until the run is over. `on_event` is called by this class, and
  /// must not call the class. Throws the exceptions of Runner::run().
  DrivenRun(Runner& runner, wire::RunRequest request, wire::OnEvent on_event = {});
  /// Ends the run unless it is over.
  ~DrivenRun();
  DrivenRun(const DrivenRun&) = delete;
  DrivenRun& operator=(const DrivenRun&) = delete;

  /// Returns the state at the present or last pause.
  const wire::Paused& state() const { return state_; }
  /// Runs actions of the script language, one per line, without their times: `press start 100ms`. The actions
  /// take effect when the run continues. Throws InputError, without effect, if an action is invalid.
  void act(const std::string& lines, std::size_t agent = 0);
  /// Returns the firmware's non-volatile memory.
  std::vector<std::uint8_t> eeprom(std::size_t agent = 0);
  /// Runs until the simulated time `to_ns`, a stop, or the verdict of a robot. Returns false after the
  /// verdict of the last robot: the run is then over. Throws InputError, without effect, if a stop is
  /// invalid.
  bool go_on(std::int64_t to_ns, const std::vector<result::Stop>& stops = {});
  /// Runs to the verdict. With several robots, runs to the verdict of the last robot.
  const result::RunResult& finish();
  /// Ends the run at its present time, with the verdict `interrupted`, unless it is over.
  const result::RunResult& end();

  bool over() const { return result_.has_value(); }
  /// Returns the result; call it only when the run is over.
  const result::RunResult& result() const { return *result_; }
  /// Returns the request's script and all later actions, with their times. The text is a scenario.
  const std::string& script(std::size_t agent = 0) const { return scripts_[agent]; }

 private:
  wire::Line ask(const wire::DrivenRequest& request);
  bool take(wire::Line line);

  Runner& runner_;
  wire::OnEvent on_event_;
  long long id_ = 0;
  std::vector<std::string> scripts_;  ///< one for each robot
  wire::Paused state_;
  std::optional<result::RunResult> result_;
};

}  // namespace robosim::client
