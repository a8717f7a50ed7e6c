// Implements Simulation and Fleet: a run, and the state of each robot in the run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robosim/testing/simulation.h"
#include "sim/launch/client/driven_run.h"
#include "sim/testing/failure_context.h"
#include "sim/testing/request_builder.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {

/// The line of the test that is responsible for a failure.
struct Spot {
  const char* file = nullptr;
  int line = 0;
};

/// A run of one robot, or a run that several robots share.
struct SharedRun {
  explicit SharedRun(const std::string& target) : runner(target) {}
  /// Begins the run, and notifies `robots`.
  void begin(const wire::RunRequest& request);
  /// Runs a leg. It ends at `to_ns`, when one of the stops is met, or when a robot gets its verdict. Does
  /// nothing if the run is over.
  void go_on(std::int64_t to_ns, const std::vector<result::Stop>& stops, Spot spot);
  /// Returns the result of robot `number` after the run is over.
  const result::RunResult& result(std::size_t number) const;
  bool over() const { return run->over(); }

  Borrowed runner;
  std::unique_ptr<client::DrivenRun> run;
  std::vector<Simulation::Impl*> robots;  ///< in the order of their numbers
  std::int64_t now_ns = 0;
  bool of_fleet = false;  ///< the Fleet ends the run and saves the artifacts
};

struct Simulation::Impl {
  /// Moves `from` to resolved_trial.
  Impl(const Trial& trial, std::shared_ptr<SharedRun> run, ResolvedTrial from);

  void take(const wire::Event& event);
  /// Records the initial state, in which the robot stands still.
  void begin();
  /// Records a leg that has just ended, and that began at `begin_ns`.
  void note_leg(std::int64_t begin_ns, Spot spot);
  void read_on(const Event::One& event);
  result::Stop stop_for(const Event::One& event) const;
  Drive drive(std::int64_t begin_ns) const {
    return Drive(log, Duration(begin_ns), Duration(shared->now_ns));
  }
  bool over() const { return log->result || shared->over(); }
  std::string verdict() const;
  const wire::Paused& state() const;
  /// Fails the test if the run failed and the test did not check its verdict.
  void complain_unasked(const result::RunResult& result) const;
  /// Fails the test if a detector has findings.
  void complain_detected(const result::RunResult& result) const;

  std::shared_ptr<RunLog> log = std::make_shared<RunLog>();
  FailureContext failure_context{log};
  ResolvedTrial resolved_trial;
  std::shared_ptr<SharedRun> shared;
  std::size_t number = 0;  ///< the robot's number
  std::size_t read = 0;    ///< number of serial bytes that have been searched
  Spot ended;              ///< line of the test during which the run ended
  Spot last;               ///< line of the test that last continued the run
};

}  // namespace robosim::testing
