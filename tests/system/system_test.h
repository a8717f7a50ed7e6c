// Runs a sketch with a robot on a map, and returns the verdict.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/build/sketch.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/fit_robot.h"
#include "sim/map/map.h"
#include "tests/support/effort.h"
#include "tests/support/require_target.h"

namespace robosim::test {

/// Returns the folder of a sketch in tests/system/sketches, or else the path of an example sketch.
inline std::filesystem::path sketch_folder(const std::string& name) {
  const std::filesystem::path own = std::filesystem::path(ROBOSIM_TEST_SKETCHES) / name;
  return std::filesystem::exists(own) ? own : build::find_sketch(name);
}

/// Parameters of a run; all except the sketch have defaults.
struct Run {
  std::string sketch;
  std::string map = "oval";
  std::string robot = "uno5";  ///< a board of the target replaces an unsuitable board
  std::string goal;
  std::string script;
  std::uint64_t seed = 1;
  double for_s = 600.0;
  std::string target = "host";
  double clock_s = 0.0;  ///< first value of millis(), on chip targets only
};

/// Returns the runner of a target. All tests of one process share this runner, so no run may disturb the
/// next.
inline client::Runner& runner_of(const std::string& target) {
  static std::map<std::string, client::Runner> runners;
  return runners.try_emplace(target, target).first->second;
}

inline wire::RunRequest request_of(const Run& run) {
  const launch::FittedRobot robot =
      launch::fit_robot(run.robot, build::boards_of(run.target),
                        [](const std::string& name) { return runner_of("host").describe_robot(name); });
  wire::RunRequest request;
  build::Request sketch{sketch_folder(run.sketch), *find_board(robot.info.board.name.c_str())};
  sketch.target = run.target;
  request.image = build::build(sketch).image;
  request.map = map::find_map(run.map);
  request.robot = robot.robot;
  request.goal = run.goal;
  request.script = run.script;
  request.seed = run.seed;
  request.for_ns = static_cast<std::int64_t>(run.for_s * 1e9);
  request.clock_ns = static_cast<std::int64_t>(run.clock_s * 1e9);
  return request;
}

inline result::RunResult run(const Run& run) { return runner_of(run.target).run(request_of(run)); }

/// Returns a message about the tools that this target lacks, or "" if it can run.
inline std::string what_is_missing(const std::string& target) {
  const std::string tool = build::missing_tool(target);
  if (!tool.empty()) return tool;
  try {
    runner_of(target);
  } catch (const ToolMissing& missing) {
    return missing.what();
  }
  return "";
}

/// Skips the test if the target cannot run. If ROBOSIM_REQUIRE names the target, the test fails instead. Call
/// this function in SetUp().
inline void needs_target(const std::string& target) {
  const std::string missing = what_is_missing(target);
  if (!missing.empty() && is_required(target)) FAIL() << missing;
  if (!missing.empty()) GTEST_SKIP() << missing;
}

/// Returns the number of seeds that ROBOSIM_TEST_SEEDS requests; 0 = not set.
inline std::uint64_t seeds_asked_for() {
  const char* text = ::getenv("ROBOSIM_TEST_SEEDS");
  return text ? std::strtoull(text, nullptr, 10) : 0;
}

/// The target and the map on which a sketch must reach its goal.
struct Trial {
  const char* target;
  const char* map;
};

inline std::string name_of(const testing::TestParamInfo<Trial>& trial) {
  return std::string(trial.param.target) + "_" + trial.param.map;
}

/// Returns a trial of each map on the host, and of the map `quick` on each chip. The chips take hundreds of
/// times as long, so they try the other maps only if ROBOSIM_TEST_SEEDS is set. In a slow build, the host
/// tries only the first four maps, and the STM32 tries none.
inline std::vector<Trial> trials(const std::vector<const char*>& maps, const char* quick) {
  std::vector<Trial> all;
  const std::size_t hosts = kSlow ? std::min<std::size_t>(maps.size(), 4) : maps.size();
  for (std::size_t i = 0; i < hosts; ++i) all.push_back({"host", maps[i]});
  const std::vector<const char*> chips = kSlow ? std::vector{"avr"} : std::vector{"avr", "stm32"};
  for (const char* chip : chips)
    for (const char* map : maps)
      if (seeds_asked_for() > 0 || map == std::string(quick)) all.push_back({chip, map});
  return all;
}

/// Returns the number of seeds for a trial.
inline std::uint64_t seeds_of(const Trial& trial) {
  if (seeds_asked_for() > 0) return seeds_asked_for();
  return trial.target == std::string("host") ? rounds(2u) : 1;
}

}  // namespace robosim::test
