// Tests in random worlds: maps, robots, faults and seeds that RapidCheck draws. A failure is reduced to the
// smallest world found that still fails. It is saved as files with the command that replays it:
// docs/howto/testing.md.
//
//   #include <robosim/random_worlds.h>   // next to <robosim/testing.h>; target robosim::random_worlds
//
//   TEST(MyNavigator, VisitsTheStationsOfEveryTree) {
//     InRandomWorlds({.trial = {.sketch = "MyNavigator", .goal = "tour"}, .maps = trees()}, runs(50),
//                    [](Simulation& robot) { EXPECT_THAT(robot.run_to_the_end(), Reaches("tour")); });
//   }
//
// The generators are ordinary RapidCheck generators of the texts that a Trial takes. They may be combined
// with RapidCheck's own, and used with rc::check and RC_GTEST_PROP.
#pragma once

#include <rapidcheck/Gen.h>
#include <robosim/testing.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace robosim::testing {

/// Limits of the size of line networks. The first worlds of a test are small.
struct Networks {
  int lines = 10;     ///< straight pieces of line, each `apart` or apart + 1 cells long
  int apart = 3;      ///< cells (of 100 mm) between landmarks: stations, junctions, bends; and between lines
                      ///< that do not meet; 2 at least
  int most_ways = 4;  ///< of a junction; 3: no crossings
  int cycles = 0;     ///< lines beyond those of a tree
  int obstacles = 0;  ///< number of obstacles, which stand on lines
};
/// Generates maps that are networks: connected, the start at a station. They shrink to fewer and shorter
/// lines, bends, cycles and obstacles.
rc::Gen<std::string> networks(Networks limits = {});
/// Generates networks without cycles and obstacles.
rc::Gen<std::string> trees(int lines = 10);

/// Limits of closed loops of line that do not cross themselves.
struct Tracks {
  int squares = 6;         ///< number of joined squares whose outline is the loop; one gives four bends
  int apart = 4;           ///< cells: the least side of a square; at most twice as long
  double cell_mm = 100.0;  ///< side of a cell
  double corner_mm = 0.0;  ///< radius of the bends; above apart · cell / 2 some become smaller
  int gaps = 0;            ///< single cells of straight line that are not painted
};
/// Generates maps with the start on the loop, between two bends, and the goal laps:1. They shrink to one
/// small square without gaps.
rc::Gen<std::string> tracks(Tracks limits = {});

/// Generates robots within the spread of a robot file (a stock robot's name, or a path). Each parameter for
/// which the file itself gives a spread gets a value within it. Floor sensors are mounted up to `mounting_mm`
/// to the front or side of their places. Robots shrink to the file's own values, except those that the
/// failure needs.
rc::Gen<std::string> robots(const std::string& file = "uno5", double mounting_mm = 1.0);

/// The faults to draw, and their worst degree; 0 = never. docs/reference/robots.md describes each.
struct Faults {
  int at_most = 1;               ///< in a run
  Duration from{};               ///< they begin between these times
  Duration until = 20_s;         ///<
  double sensor_offset = 0.05;   ///< share of white to black, either way
  double sensor_noise = 0.03;    ///< standard deviation, a share of white to black
  Duration covered{};            ///< the duration for which a sensor sees black
  double motor_weakness = 0.1;   ///< share of the voltage that a motor lacks
  double clock_drift_ppm = 5e3;  ///< either way
};
/// Generates scripts with faults of a robot. They shrink to fewer and milder faults, at full seconds.
rc::Gen<std::string> faults(const std::string& robot = "uno5", Faults limits = {});

/// The worlds of a test.
struct Worlds {
  Trial trial;                                       ///< what is not random
  std::optional<rc::Gen<std::string>> maps = {};     ///< for Trial::map
  std::optional<rc::Gen<std::string>> robots = {};   ///< for Trial::robot
  std::optional<rc::Gen<std::string>> scripts = {};  ///< such as faults(); they follow Trial::script
  std::uint64_t seeds = 1'000;                       ///< Trial::seed is from 1 to this; 1 = the trial's own
};

/// Generates trials in such worlds.
rc::Gen<Trial> trials(const Worlds& worlds);

/// The number of worlds to try; ROBOSIM_TEST_SEEDS=N overrides it.
struct Runs {
  int count = 20;
};
Runs runs(int count);

/// Runs `body`, which drives the robot and has expectations as any test, in that number of worlds. After the
/// first failure it tries smaller worlds, repeatedly, until none of them fails. The test then fails with the
/// smallest one, and prints what is in it. Every run draws the same worlds; RC_PARAMS="seed=7" draws others.
void InRandomWorlds(const Worlds& worlds, Runs runs, const std::function<void(Simulation&)>& body,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace robosim::testing
