// The target runs of `robosim compare`: one for each target, with the same robots in each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/compare/compare_options.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/fleet.h"
#include "sim/launch/run_json.h"

namespace robosim::campaign {

/// A target, its robots, and its runner.
struct TargetRun {
  std::string target;  ///< target of the compared robots
  client::Runner runner;
  launch::Fleet fleet;        ///< without members for a single robot
  launch::PreparedFleet run;  ///< also set for a single robot

  /// Returns a robot's name by its number.
  const std::string& name(std::size_t robot) const;
  /// Returns whether a robot's sketch runs on the host in this target run.
  bool is_on_host(std::size_t robot) const { return run.members[robot].target == "host"; }
  static std::string& script(wire::RunRequest& request, std::size_t robot);
  static std::vector<result::Lateness>& late(wire::RunRequest& request, std::size_t robot);
  launch::RunInputs inputs(std::size_t robot) const;
};

/// Makes the target runs. Throws InputError and ToolMissing.
std::vector<TargetRun> target_runs_of(const CompareOptions& options, const launch::Listener& listener);
/// Makes a target run for a target that is not compared. Throws InputError and ToolMissing.
TargetRun target_run_of(const CompareOptions& options, const std::string& target,
                        const launch::Listener& listener);

/// The result of each robot, in the order of their numbers.
using Results = std::vector<result::RunResult>;

/// Runs `requests[i]` on `target_runs[i]`, for all i simultaneously.
std::vector<Results> run_all(const std::vector<TargetRun*>& target_runs,
                             const std::vector<wire::RunRequest>& requests,
                             const std::vector<wire::OnEvent>& listeners);

}  // namespace robosim::campaign
