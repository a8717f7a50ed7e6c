// A sketch, a robot and a map in; a verdict out.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "hal/board/board_spec.h"
#include "sim/client/runner.h"
#include "sim/grid/map.h"
#include "sim/sketch/sketch.h"

namespace robosim::test {

/// The folder of a test's own sketch, or the path of one of ours.
inline std::filesystem::path sketch_folder(const std::string& name) {
  const std::filesystem::path own = std::filesystem::path(ROBOSIM_TEST_SKETCHES) / name;
  return std::filesystem::exists(own) ? own : sketch::find_sketch(name);
}

/// What a run needs; everything but the sketch has a default.
struct Run {
  std::string sketch;
  std::string map = "oval";
  std::string robot = "uno5";
  std::string goal;
  std::string script;
  std::uint64_t seed = 1;
  double for_s = 600.0;
  std::string target = "host";
  double clock_s = 0.0;  ///< what millis() begins with; chip targets only
};

inline client::RunRequest request_of(const Run& run) {
  client::Runner& runner = *[] {
    static client::Runner host("host");
    return &host;
  }();
  const std::string board = runner.describe_robot(run.robot).board.name;
  client::RunRequest request;
  sketch::Request sketch{sketch_folder(run.sketch), *find_board(board.c_str())};
  sketch.target = run.target;
  request.image = sketch::build(sketch).image;
  request.map = grid::find_map(run.map);
  request.robot = run.robot;
  request.goal = run.goal;
  request.script = run.script;
  request.seed = run.seed;
  request.for_ns = static_cast<std::int64_t>(run.for_s * 1e9);
  request.clock_ns = static_cast<std::int64_t>(run.clock_s * 1e9);
  return request;
}

/// All tests of one process share a runner: no run may harm the next.
inline client::RunResult run(const Run& run) {
  static std::map<std::string, client::Runner> runners;
  const auto runner = runners.try_emplace(run.target, run.target).first;
  return runner->second.run(request_of(run));
}

}  // namespace robosim::test
