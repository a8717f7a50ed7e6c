// A run that is driven step by step: it stands still at t = 0 and at every stop; meanwhile its state is known
// and lines of the scenario language can be carried out.
//
//   request.samples_every_ns = …;
//   client::DrivenRun run(runner, request, on_event);
//   run.act("press start 100ms");
//   if (run.go_on(5'000'000'000, {client::Stop::serial("ready")})) …   // stands still at 5 s, or earlier
//   const client::RunResult result = run.end();
//
// The same lines as a script at the same times, run.script(), give the same trace.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/client/runner.h"

namespace robosim::client {

class DrivenRun {
 public:
  /// Starts a run of its own on a runner, which serves nobody else until it is over. `on_event` is called
  /// while a call of ours lasts, and must not call us. Throws as Runner::run does.
  DrivenRun(Runner& runner, wire::RunRequest request, wire::OnEvent on_event = {});
  /// Ends the run if it is not over.
  ~DrivenRun();
  DrivenRun(const DrivenRun&) = delete;
  DrivenRun& operator=(const DrivenRun&) = delete;

  /// The state where it stands, or stood last.
  const wire::Paused& state() const { return state_; }
  /// Carries out actions of the script language, one per line, without their times: `press start 100ms`. They
  /// happen as soon as the run goes on. Throws InputError, and does nothing, if one makes no sense.
  void act(const std::string& lines, std::size_t agent = 0);
  /// The firmware's non-volatile memory.
  std::vector<std::uint8_t> eeprom(std::size_t agent = 0);
  /// Runs until the simulated time `to_ns`, one of the stops or a robot's verdict. False if that was the last
  /// one's: the run is then over. Throws InputError, and stays where it is, if a stop makes no sense.
  bool go_on(std::int64_t to_ns, const std::vector<wire::Stop>& stops = {});
  /// Runs to the verdict, of several robots to the last one's.
  const wire::RunResult& finish();
  /// Ends it where it stands, with the verdict `interrupted`, unless it is over.
  const wire::RunResult& end();

  bool over() const { return result_.has_value(); }
  /// Once it is over.
  const wire::RunResult& result() const { return *result_; }
  /// The request's script and all that was done since, with its times: a scenario.
  const std::string& script(std::size_t agent = 0) const { return scripts_[agent]; }

 private:
  wire::Line ask(const wire::DrivenRequest& request);
  bool take(wire::Line line);

  Runner& runner_;
  wire::OnEvent on_event_;
  long long id_ = 0;
  std::vector<std::string> scripts_;  ///< of each robot
  wire::Paused state_;
  std::optional<wire::RunResult> result_;
};

}  // namespace robosim::client
