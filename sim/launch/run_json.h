// Writes the JSON of `robosim run --json`, schema robosim.run/1. docs/reference/json.md describes every key.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/launch/launch.h"
#include "sim/result/run_result.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// The inputs of a result. They must not depend on the machine: equal inputs give equal bytes.
struct RunInputs {
  std::string robosim;  ///< version
  std::string target;
  std::string sketch;  ///< sketch, map and robot are as the user named them
  std::string map;
  std::string robot;
  std::string sketch_sha256;
  std::string compiler;
  bool sanitize = false;
};
/// Returns the inputs of a prepared run. `robosim` is the version that the runner reports.
RunInputs inputs_of(const Prepared& run, const std::string& robosim);

/// Returns one JSON object, indented by two spaces, with a line feed at its end. `wall_s` is the run's wall
/// time in seconds; only --timing includes it.
std::string run_json(const RunInputs& inputs, const result::RunResult& result, std::optional<double> wall_s,
                     const std::optional<result::Finding>& finding = {});

/// Returns the object in one line, for JSON Lines.
std::string run_json_line(const RunInputs& inputs, const result::RunResult& result);

/// One robot of a fleet, with its result.
struct RobotRun {
  std::string name;
  RunInputs inputs;
  result::RunResult result;
};

/// Formats robosim.fleet/1: the number of robots that reached their goals, and each robot's object with its
/// name.
std::string fleet_json(const std::vector<RobotRun>& robots, std::optional<double> wall_s);

}  // namespace robosim::launch
