// The implementation of Simulation and Fleet: a run, and the state of each robot in it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robosim/testing/simulation.h"
#include "sim/client/driven_run.h"
#include "sim/testing/failure_context.h"
#include "sim/testing/request_builder.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {

/// The test's line to which a failure belongs.
struct Spot {
  const char* file = nullptr;
  int line = 0;
};

/// A run of one robot, or one that several share.
struct SharedRun {
  explicit SharedRun(const std::string& target) : runner(target) {}
  /// Begins the run, and notifies `robots`.
  void begin(const wire::RunRequest& request);
  /// Runs a leg: until that time, the first of the stops, or a verdict of one of them. Does nothing if it is
  /// over.
  void go_on(std::int64_t to_ns, const std::vector<wire::Stop>& stops, Spot spot);
  /// Returns the result of robot `number`, once it is over.
  const wire::RunResult& result(std::size_t number) const;
  bool over() const { return run->over(); }

  Borrowed runner;
  std::unique_ptr<client::DrivenRun> run;
  std::vector<Simulation::Impl*> robots;  ///< by their number
  std::int64_t now_ns = 0;
  bool of_fleet = false;  ///< a Fleet ends it, and keeps what there is to keep
};

struct Simulation::Impl {
  /// The robot's resolved trial becomes this one's.
  Impl(const Trial& trial, std::shared_ptr<SharedRun> run, ResolvedTrial from);

  void take(const wire::Event& event);
  /// Notes the initial state, in which the robot stands still.
  void begin();
  /// Notes a leg that has just ended, and began at `begin_ns`.
  void note_leg(std::int64_t begin_ns, Spot spot);
  void read_on(const Event::One& event);
  wire::Stop stop_for(const Event::One& event) const;
  Drive drive(std::int64_t begin_ns) const {
    return Drive(log, Duration(begin_ns), Duration(shared->now_ns));
  }
  bool over() const { return log->result || shared->over(); }
  std::string verdict() const;
  const wire::Paused& state() const;
  /// Fails the test if the run ended in a way that no expectation looked at.
  void complain_unasked(const wire::RunResult& result) const;
  /// Fails the test if a detector has seen something.
  void complain_detected(const wire::RunResult& result) const;

  std::shared_ptr<RunLog> log = std::make_shared<RunLog>();
  FailureContext failure_context{log};
  ResolvedTrial resolved_trial;
  std::shared_ptr<SharedRun> shared;
  std::size_t number = 0;  ///< among the robots
  std::size_t read = 0;    ///< bytes of the serial text that are done with
  Spot ended;              ///< where the run ended, ...
  Spot last;               ///< and where it went on last
};

}  // namespace robosim::testing
