// Several robots on one map, driven step by step: docs/testing.md.
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

/// One robot. As in a Trial; only name and sketch have no default.
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
  std::string file;                 ///< with [[agent]]s: docs/fleets.md
  std::string map;                  ///< as in a Trial; "" = the file's, else the first sketch's, else oval
  std::uint64_t seed = 1;
  std::string profile = "typical";
  Duration limit = std::chrono::hours(1);
  bool detect = true;
};

class Fleet {
 public:
  /// Compiles the sketches and puts the robots on the map; time stands at 0. Throws as Simulation does, with
  /// the name of the robot that it is about.
  explicit Fleet(FleetTrial trial);
  /// Ends the run; what a robot did that fails a test, and what is kept then, is as for a Simulation.
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// All that a Simulation can do, of this robot. Its time is that of all: while it runs, so do the others.
  /// Throws if there is none of that name.
  Simulation& robot(const std::string& name);
  const std::vector<std::string>& names() const { return names_; }

  void run_for(Duration time, const char* file = __builtin_FILE(), int line = __builtin_LINE());
  /// To each robot's verdict.
  void run_to_the_end(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  Duration now() const;
  /// Whether each has its verdict.
  bool over() const;
  /// Of each robot, in their order; "" until it has one.
  std::vector<std::string> verdicts() const;
  /// For EXPECT_TRUE: whether all have reached their goals; else who has not, and why.
  ::testing::AssertionResult all_reached() const;
  /// The command that gives this very run until now; its files are there if the test fails.
  std::string replay_command() const;

 private:
  struct Inside;
  std::vector<std::string> names_;
  std::filesystem::path scratch_;  ///< texts as files
  std::vector<std::unique_ptr<Simulation>> robots_;
  std::unique_ptr<Inside> in_;
};

}  // namespace robosim::testing
