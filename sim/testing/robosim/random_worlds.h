// Tests in random worlds: maps, robots, faults and seeds that RapidCheck draws. A failure is reduced to the
// smallest world found that still fails, and kept as files with the command that replays it: docs/testing.md.
//
//   #include <robosim/random_worlds.h>   // beside <robosim/testing.h>; target robosim::random_worlds
//
//   TEST(MyNavigator, VisitsTheStationsOfEveryTree) {
//     InRandomWorlds({.trial = {.sketch = "MyNavigator", .goal = "tour"}, .maps = trees()}, runs(50),
//                    [](Simulation& robot) { EXPECT_THAT(robot.run_to_the_end(), Reaches("tour")); });
//   }
//
// The generators are ordinary RapidCheck generators of the texts that a Trial takes: they may be combined
// with RapidCheck's own, and used with rc::check and RC_GTEST_PROP.
#pragma once

#include <rapidcheck/Gen.h>
#include <robosim/testing.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace robosim::testing {

/// Networks of lines, at most so large; the first worlds of a test are small.
struct Networks {
  int lines = 10;     ///< straight pieces of line, each `apart` or apart + 1 cells long
  int apart = 3;      ///< cells (of 100 mm) between landmarks: stations, junctions, bends; and between lines
                      ///< that do not meet; 2 at least
  int most_ways = 4;  ///< of a junction; 3: no crossings
  int cycles = 0;     ///< lines beyond those of a tree
  int obstacles = 0;  ///< that stand on lines
};
/// Maps that are networks: connected, the start at a station. They shrink to fewer and shorter lines, bends,
/// cycles and obstacles.
rc::Gen<std::string> networks(Networks limits = {});
/// Without cycles and obstacles.
rc::Gen<std::string> trees(int lines = 10);

/// Closed loops of line that do not cross themselves.
struct Tracks {
  int squares = 6;         ///< whose outline the loop is; one square gives a loop of four bends
  int apart = 4;           ///< cells: the least side of a square; at most twice as long
  double cell_mm = 100.0;  ///< side of a cell
  double corner_mm = 0.0;  ///< radius of the bends; above apart · cell / 2 some become smaller
  int gaps = 0;            ///< single cells of straight line that are not painted
};
/// Maps with the start on the loop, between two bends, and the goal laps:1. They shrink to one small square
/// without gaps.
rc::Gen<std::string> tracks(Tracks limits = {});

/// Robots that a robot file stands for (a stock robot's name, or a path): each figure with a spread that the
/// file itself gives has some value within it, and its floor sensors are mounted up to `mounting_mm` to the
/// front or side of their places. They shrink to the file's own figures; which differ is what the failure
/// needs.
rc::Gen<std::string> robots(const std::string& file = "uno5", double mounting_mm = 1.0);

/// What may break, and how badly at most; 0 = never. docs/robots.md says what each does.
struct Faults {
  int at_most = 1;               ///< in a run
  Duration from{};               ///< they begin between these times
  Duration until = 20_s;         ///<
  double sensor_offset = 0.05;   ///< share of white to black, either way
  double sensor_noise = 0.03;    ///< standard deviation, a share of white to black
  Duration covered{};            ///< a sensor sees black for so long
  double motor_weakness = 0.1;   ///< share of the voltage that a motor lacks
  double clock_drift_ppm = 5e3;  ///< either way
};
/// Scripts that break things of a robot. They shrink to fewer and milder faults, at full seconds.
rc::Gen<std::string> faults(const std::string& robot = "uno5", Faults limits = {});

/// Where a test takes place.
struct Worlds {
  Trial trial;                                       ///< what is not random
  std::optional<rc::Gen<std::string>> maps = {};     ///< for Trial::map
  std::optional<rc::Gen<std::string>> robots = {};   ///< for Trial::robot
  std::optional<rc::Gen<std::string>> scripts = {};  ///< such as faults(); they follow Trial::script
  std::uint64_t seeds = 1'000;                       ///< Trial::seed is from 1 to this; 1 = the trial's own
};

/// The trials that they give.
rc::Gen<Trial> trials(const Worlds& worlds);

/// How many worlds to try; ROBOSIM_TEST_SEEDS=N makes them N.
struct Runs {
  int count = 20;
};
Runs runs(int count);

/// Runs `body`, which drives the robot and expects things as any test does, in so many worlds. After the
/// first one that fails it tries smaller ones, again and again, until none of them fails; the test then fails
/// with that, and tells what is in it. Equal on every run; RC_PARAMS="seed=7" gives other worlds.
void InRandomWorlds(const Worlds& worlds, Runs runs, const std::function<void(Simulation&)>& body,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace robosim::testing
