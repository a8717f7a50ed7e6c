// A sketch, a robot and a map in; a verdict out.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
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
};

inline client::RunRequest request_of(const Run& run) {
  client::Runner& runner = *[] {
    static client::Runner host("host");
    return &host;
  }();
  const std::string board = runner.describe_robot(run.robot).board.name;
  client::RunRequest request;
  request.image = sketch::build({sketch_folder(run.sketch), *find_board(board.c_str())}).image;
  request.map = grid::find_map(run.map);
  request.robot = run.robot;
  request.goal = run.goal;
  request.script = run.script;
  request.seed = run.seed;
  request.for_ns = static_cast<std::int64_t>(run.for_s * 1e9);
  return request;
}

/// All tests of one process share a runner: no run may harm the next.
inline client::RunResult run(const Run& run) {
  static client::Runner runner("host");
  return runner.run(request_of(run));
}

}  // namespace robosim::test
