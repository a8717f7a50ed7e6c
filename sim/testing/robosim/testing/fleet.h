// Several robots on one map, driven step by step: docs/howto/testing.md.
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

/// One robot, with members as in a Trial. Only name and sketch have no default.
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

/// The robots to run, or a file with them.
struct FleetTrial {
  std::vector<FleetMember> robots;  ///< in the order of their numbers
  std::string file;                 ///< a file with [[agent]] tables: docs/howto/fleets.md
  std::string map;                  ///< as in a Trial; "" = the file's, else the first sketch's, else oval
  std::uint64_t seed = 1;
  std::string profile = "typical";
  Duration limit = std::chrono::hours(1);
  bool detect = true;
};

class Fleet {
 public:
  /// Compiles the sketches and puts the robots on the map; time is 0. Throws as Simulation does, with the
  /// robot's name.
  explicit Fleet(FleetTrial trial);
  /// Ends the run. Failures and saved files are as for a Simulation.
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// Returns the Simulation of this robot. All robots share one time: running one runs the others, too.
  /// Throws for an unknown name.
  Simulation& robot(const std::string& name);
  const std::vector<std::string>& names() const { return names_; }

  void run_for(Duration time, const char* file = __builtin_FILE(), int line = __builtin_LINE());
  /// Runs to each robot's verdict.
  void run_to_the_end(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  Duration now() const;
  /// Returns whether each robot has its verdict.
  bool over() const;
  /// Returns the verdicts in the robots' order; "" for a robot without one.
  std::vector<std::string> verdicts() const;
  /// Returns success if all robots have reached their goals, for EXPECT_TRUE; else which have not, and why.
  ::testing::AssertionResult all_reached() const;
  /// Returns the command that reproduces this run until now; its files exist if the test fails.
  std::string replay_command() const;

 private:
  struct Impl;
  std::vector<std::string> names_;
  std::filesystem::path scratch_;  ///< folder with the files of texts, such as a map
  std::vector<std::unique_ptr<Simulation>> robots_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace robosim::testing
