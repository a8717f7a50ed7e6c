// Runs several robots on one map, driven step by step: docs/howto/testing.md.
//
//   Fleet both({.robots = {{.name = "A", .sketch = "MyFollower", .goal = "laps:1"},
//                          {.name = "B", .sketch = "MyFollower", .target = "avr", .start = "20,2,W"}},
//               .map = "oval"});
//   ASSERT_TRUE(both.robot("A").run_until(collides(), within(10_s)));
//   EXPECT_TRUE(both.robot("B").is_on("LED"));
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// One robot. Its members mean the same as the members of a Trial. Only name and sketch have no default.
struct FleetMember {
  std::string name;  ///< letters, digits, _ and -
  std::string sketch;
  std::string robot;
  std::string target = "host";
  std::string start;
  std::string goal = "none";
  std::string script;
  Duration clock_start{};
  std::vector<std::string> libraries;
};

/// The robots to run, or a file that lists them.
struct FleetTrial {
  std::vector<FleetMember> robots;  ///< in the order of their numbers
  std::string file;                 ///< a file with [[agent]] tables: docs/howto/fleets.md
  std::string map;                  ///< as in a Trial; "" = the map of `file`, of the first sketch, or oval
  std::uint64_t seed = 1;
  std::string profile = "typical";
  Duration limit = std::chrono::hours(1);
  bool detect = true;
};

class Fleet {
 public:
  /// Compiles the sketches and puts the robots on the map at time 0. Throws the same exceptions as
  /// Simulation, with the robot's name.
  explicit Fleet(FleetTrial trial);
  /// Ends the run. Reports failures and saves files as Simulation does.
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// Returns the Simulation of this robot. All robots share one time: running one robot runs the others, too.
  /// Throws for an unknown name.
  Simulation& robot(const std::string& name);
  const std::vector<std::string>& names() const { return names_; }

  void run_for(Duration time, const char* file = __builtin_FILE(), int line = __builtin_LINE());
  /// Runs until all robots have their verdicts.
  void run_to_the_end(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  Duration now() const;
  /// Returns whether all robots have their verdicts.
  bool over() const;
  /// Returns the verdicts in the order of the robots; "" for a robot without a verdict.
  std::vector<std::string> verdicts() const;
  /// Returns success if all robots have reached their goals, for EXPECT_TRUE. Otherwise names the robots that
  /// have not, with the reasons.
  ::testing::AssertionResult all_reached() const;
  /// Returns the command that reproduces this run until now. If the test fails, the files that the command
  /// names are saved.
  std::string replay_command() const;

 private:
  struct Impl;
  std::vector<std::string> names_;
  std::filesystem::path scratch_;  ///< folder for maps and robots that were given as texts
  std::vector<std::unique_ptr<Simulation>> robots_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace robosim::testing
