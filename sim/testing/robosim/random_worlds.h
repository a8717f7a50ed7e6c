// Runs tests in random worlds: maps, robots, faults and seeds that RapidCheck draws. A failure is reduced to
// the smallest failing world that the search finds. This world is saved as files, with the command that
// replays it: docs/howto/testing.md.
//
//   #include <robosim/random_worlds.h>   // next to <robosim/testing.h>; target robosim::random_worlds
//
//   TEST(MyNavigator, VisitsTheStationsOfEveryTree) {
//     InRandomWorlds({.trial = {.sketch = "MyNavigator", .goal = "tour"}, .maps = trees()}, runs(50),
//                    [](Simulation& robot) { EXPECT_THAT(robot.run_to_the_end(), Reaches("tour")); });
//   }
//
// The generators are RapidCheck generators of texts for a Trial. They can be combined with
// RapidCheck's own generators, and used with rc::check and RC_GTEST_PROP.
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
  int apart = 3;      ///< cells (of 100 mm) between landmarks (stations, junctions, bends), and between
                      ///< lines that do not meet; at least 2
  int most_ways = 4;  ///< arms of a junction; 3 = no crossings
  int cycles = 0;     ///< lines in addition to those of a tree
  int obstacles = 0;  ///< obstacles on lines
};
/// Generates maps that are connected networks with the start at a station. They shrink to fewer and shorter
/// lines, and fewer bends, cycles and obstacles.
rc::Gen<std::string> networks(Networks limits = {});
/// Generates networks without cycles and obstacles.
rc::Gen<std::string> trees(int lines = 10);

/// Limits of closed loops of line that do not cross themselves.
struct Tracks {
  int squares = 6;         ///< joined squares whose outline is the loop; one square has four bends
  int apart = 4;           ///< shortest side of a square, in cells; the longest is at most twice as long
  double cell_mm = 100.0;  ///< side of a cell
  double corner_mm = 0.0;  ///< radius of the bends; some are smaller if this exceeds apart · cell_mm / 2
  int gaps = 0;            ///< single cells of straight line that are not painted
};
/// Generates maps with the goal laps:1 and the start on the loop, between two bends. They shrink to one small
/// square without gaps.
rc::Gen<std::string> tracks(Tracks limits = {});

/// Generates robots within the spread of a robot file. `file` is a stock robot's name, or a path. Each
/// parameter with a spread in the file gets a value within this spread. Floor sensors are up to `mounting_mm`
/// off their positions, to the front or side. Robots shrink to the values in the file, except for parameters
/// that the failure needs.
rc::Gen<std::string> robots(const std::string& file = "uno5", double mounting_mm = 1.0);

/// The faults to draw, with their maximum severity; 0 = never. docs/reference/robots.md describes each fault.
struct Faults {
  int at_most = 1;               ///< maximum number of faults per run
  Duration from{};               ///< earliest beginning
  Duration until = 20_s;         ///< latest beginning
  double sensor_offset = 0.05;   ///< share of the range from white to black, in either direction
  double sensor_noise = 0.03;    ///< standard deviation, share of the range from white to black
  Duration covered{};            ///< duration for which a sensor reads black
  double motor_weakness = 0.1;   ///< share of the voltage that a motor loses
  double clock_drift_ppm = 5e3;  ///< in either direction
};
/// Generates scripts with faults of a robot. They shrink to fewer and milder faults, at whole seconds.
rc::Gen<std::string> faults(const std::string& robot = "uno5", Faults limits = {});

/// The worlds of a test.
struct Worlds {
  Trial trial;                                       ///< everything that is not random
  std::optional<rc::Gen<std::string>> maps = {};     ///< values of Trial::map
  std::optional<rc::Gen<std::string>> robots = {};   ///< values of Trial::robot
  std::optional<rc::Gen<std::string>> scripts = {};  ///< such as faults(); appended to Trial::script
  std::uint64_t seeds = 1'000;                       ///< largest seed to draw; 1 = always Trial::seed
};

/// Generates trials in these worlds.
rc::Gen<Trial> trials(const Worlds& worlds);

/// The number of worlds to try. The environment variable ROBOSIM_TEST_SEEDS=N overrides it.
struct Runs {
  int count = 20;
};
Runs runs(int count);

/// Runs `body` in `runs` random worlds. `body` drives the robot and contains expectations like any test.
/// After the first failure, smaller worlds are tried repeatedly until none of them fails. The test then fails
/// with the smallest failing world, and prints its content. The test draws the same worlds each time. The
/// environment variable RC_PARAMS="seed=7" selects other worlds.
void InRandomWorlds(const Worlds& worlds, Runs runs, const std::function<void(Simulation&)>& body,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace robosim::testing
