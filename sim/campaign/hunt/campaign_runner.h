// Makes the runs of a hunt: compiles a sketch for each build, and writes test cases as files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/build/cache.h"
#include "sim/campaign/hunt/hunt_options.h"
#include "sim/campaign/hunt/test_case.h"
#include "sim/launch/client/pool.h"
#include "sim/launch/launch.h"

namespace robosim::campaign {

class CampaignRunner {
 public:
  /// Compiles the sketch. Throws InputError, ToolMissing and wire::RunnerError.
  CampaignRunner(const HuntOptions& options, launch::Listener listener);

  HuntSpace& space() { return space_; }
  const HuntSpace& space() const { return space_; }
  const wire::RobotInfo& robot() const { return robot_; }
  const launch::Prepared& of(const TestCase& test_case) const { return prepared_[test_case.build]; }
  const std::string& version() const { return version_; }
  /// Returns the board that replaces the robot's own board; empty = none.
  const std::string& board() const { return board_; }
  /// Returns why requested builds are skipped, one sentence each.
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// Returns the fingerprint of everything that affects the runs.
  std::string fingerprint() const;
  /// Returns whether the maps are given: by the user, or by a map next to the sketch. Otherwise the maps are
  /// guesses that may be dropped.
  bool maps_are_given() const { return maps_are_given_; }
  void keep_maps(const std::vector<std::size_t>& maps);
  /// Returns the names of the dropped maps, for which the sketch is apparently not meant.
  const std::vector<std::string>& left_maps() const { return left_maps_; }

  /// Returns the script of a test case: the user's script, followed by the test case's script.
  std::string script_of(const TestCase& test_case) const { return script_ + script_text(test_case, space_); }
  /// Returns the request of a test case. If the test case has its own map or robot, writes it to `folder` as
  /// world.map or robot.toml.
  wire::RunRequest request_of(const TestCase& test_case, const std::string& folder) const;

  /// Runs test cases and sets their results, in the same order. The result of a test case that the runner
  /// refuses is nullopt. `ran` receives the lines of the sketch that ran, for test cases on a chip in a
  /// build without checks (sanitizers). Returns false if the user interrupted the runs.
  bool run(const std::vector<TestCase>& test_cases, std::vector<std::optional<result::RunResult>>& results,
           std::vector<std::vector<std::string>>* ran = nullptr);
  client::Pool& pool() { return pool_; }
  /// Return the number of refused test cases, and the reason for the first refusal.
  std::size_t refused() const { return refused_; }
  const std::string& refusal() const { return refusal_; }

 private:
  /// A run of one test case, or of all test cases of a family (TestCase::family).
  struct Task {
    std::size_t first = 0, count = 1;
  };
  std::vector<Task> tasks_of(const std::vector<TestCase>& test_cases) const;
  wire::RunRequest request_of_all(const std::vector<TestCase>& test_cases, const Task& task,
                                  const std::string& folder) const;
  void prepare(const HuntOptions& options, launch::Listener listener);
  void look_at_maps(const HuntOptions& options);
  void look_at_robot(const HuntOptions& options, client::Runner& describer);
  void look_at_sketch();

  build::WorkFolder work_;
  client::Pool pool_;
  HuntSpace space_;
  wire::RobotInfo robot_;
  std::string board_;                       ///< replaces the board of the robot file
  std::string script_;                      ///< the script of the user
  std::vector<launch::Prepared> prepared_;  ///< for each build
  std::vector<std::string> map_files_;      ///< for each map
  std::vector<std::string> left_maps_;
  std::vector<std::string> left_out_;
  std::string version_;
  std::string options_;  ///< all options, one per line
  std::size_t refused_ = 0;
  std::string refusal_;
  bool maps_are_given_ = false;
};

}  // namespace robosim::campaign
