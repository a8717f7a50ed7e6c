// Draws the test cases of a hunt at random, and shrinks them. A drawn map is a randomly generated map.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/check/text_assertions.h"
#include "sim/campaign/random_worlds/fault_plan.h"
#include "sim/campaign/random_worlds/line_network.h"
#include "sim/campaign/random_worlds/robot_variant.h"
#include "sim/campaign/random_worlds/track.h"
#include "sim/map/map.h"

namespace robosim::campaign {

/// A stimulus for the robot.
struct Stimulus {
  int at_ms = 0;     ///< ms after power-on, or after the sketch has sent `after`
  std::string what;  ///< in script syntax: "press start 100ms"
  std::string kind;  ///< for display: "press start", "send"
  std::string after = {};
  bool operator==(const Stimulus&) const = default;
};

inline constexpr const char* kPowerOff = "power off";
inline constexpr const char* kUsedEeprom = "an EEPROM that another sketch has filled";
inline constexpr const char* kObstacle = "an obstacle";
inline constexpr const char* kHeld = "a held wheel";
inline constexpr const char* kTwisted = "a twist";  ///< a manual move turns the robot, against its motors

/// A time after power-on, ms, at which a sketch has finished its one-time actions. It is a multiple of 2^16,
/// so that a 16-bit clock also starts at 0.
inline constexpr std::int64_t kPast_ms = 4 << 16;

/// The kind of a second run for comparison: see differential_testing.h.
enum class Differential : std::uint8_t { none, host, clock };

/// The moment at which a run showed something new: a time, or an output of the sketch. Empty = unknown.
struct Moment {
  int at_ms = -1;
  std::string after = {};
  bool is_known() const { return at_ms >= 0 || !after.empty(); }
};

struct TestCase {
  Differential differential = Differential::none;
  std::size_t build = 0;  ///< index in HuntSpace::builds
  std::size_t map = 0;    ///< index in HuntSpace::maps; a drawn map resembles this map
  std::optional<random_worlds::Track> track;
  std::optional<random_worlds::LineNetwork> network;
  random_worlds::RobotVariant robot;  ///< if it has no levels, the unchanged robot of the file
  std::uint64_t seed = 1;
  random_worlds::FaultPlan faults;
  std::vector<Stimulus> stimuli;
  int later_ms = 0;  ///< delay of the opening relative to the baseline run
  std::int64_t clock_ms = 0;
  std::uint64_t family = 0;  ///< number of a family; 0 = none. A family's test cases are equal up to
                             ///< `branch_point` and differ in the last stimulus. On a chip, a family is
                             ///< one run that branches (wire::Ways)
  Moment branch_point = {};
  bool to_goal = true;   ///< the run ends at the goal; false: when its time is up
  bool is_long = false;  ///< the run may last for HuntSpace::for_ms
  int least_ms = 0;      ///< minimum duration
  double for_s = 60.0;

  bool drawn() const { return track || network; }
};

/// The choices from which test cases are drawn.
struct HuntSpace {
  /// A build: its target, and whether the sketch is compiled with the checks of --sanitize.
  struct Build {
    std::string target;
    bool checked = false;
  };
  struct Map {
    std::string name;
    std::string goal;                       ///< empty = the map's goal
    bool tracks = false, networks = false;  ///< which kind of random maps resembles this map
    int cycles = 0;                         ///< approximate number of cycles of its network
    double cell_mm = 100.0, corner_mm = 0.0;
    std::vector<map::CellAt> line = {};  ///< cells with line, except the start
    bool tours = true;                   ///< the sketch also reaches its goal on similar maps
  };
  std::vector<Build> builds;
  std::optional<std::size_t> host_counterpart;  ///< the last build, with which chips are compared
  std::vector<Map> maps;
  bool draws_maps = true;
  std::string robot;  ///< the base of the variants: a name or a path
  std::vector<random_worlds::Figure> figures;
  random_worlds::Breakable parts;
  random_worlds::FaultLimits limits;
  std::vector<std::string> buttons;  ///< buttons and keys
  std::vector<std::pair<std::string, std::string>>
      listeners;                   ///< parts that receive messages, and their types
  std::vector<std::string> words;  ///< words that may be sent; empty = none
  std::size_t own_words = 0;       ///< number of the sketch's own words, at the end of `words`
  std::vector<Stimulus> opening;   ///< stimuli that start the robot
  std::vector<std::string> said;   ///< beginnings of the sketch's lines in the baseline run;
                                   ///< the last line last
  bool uses_eeprom = false;        ///< the sketch uses the EEPROM
  bool feels = false;              ///< a bumper changes the sketch's behaviour, so that obstacles are useful
  std::vector<TextAssertion> assertions;
  int for_ms = 60'000;    ///< maximum duration of a run
  int usual_ms = 60'000;  ///< maximum duration of most runs
};

/// Returns the approximate duration of a test case's run.
inline int span_ms(const TestCase& test_case, const HuntSpace& space) {
  return std::max(test_case.least_ms, test_case.is_long ? space.for_ms : space.usual_ms);
}
/// Returns the stimuli that start the robot in this test case.
std::vector<Stimulus> opening_of(const TestCase& test_case, const HuntSpace& space);

/// Returns the number of builds that test cases may draw.
inline std::size_t drawn_builds(const HuntSpace& space) {
  return space.builds.size() - (space.host_counterpart ? 1 : 0);
}

/// A test case in which something new was seen.
struct Noted {
  TestCase test_case;
  Moment moment = {};
};

/// Draws a test case for each run. A test case depends on the hunt's seed, the run's number and the noted
/// test cases. Half of the test cases vary a noted test case. A fifth of these branch from it: they equal it
/// up to the noted moment, and then have another stimulus. On a chip, the last test cases of a whole round
/// all branch from one moment.
std::vector<TestCase> draw_round(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                                 const std::vector<std::uint64_t>& runs);
inline constexpr std::size_t kRound = 12, kFamily = 3;  ///< number of test cases in a round and in a family

/// Draws `count` test cases with only the opening as stimuli, each on another network similar to the map.
std::vector<TestCase> networks_like(const HuntSpace& space, std::size_t map, std::uint64_t seed,
                                    std::size_t count);

/// Returns the test cases that are simpler by one step, beginning with the largest steps. Repeated shrinking
/// ends after finitely many steps.
std::vector<TestCase> smaller(const TestCase& test_case, const HuntSpace& space);

/// Returns the differences from the baseline: "a drawn map", "another seed", "fault noisy", "press start".
/// The opening does not count.
std::set<std::string> needs_of(const TestCase& test_case, const HuntSpace& space);

/// Returns the cells of the test case's map that have line, except the start.
std::vector<map::CellAt> cells_with_line(const TestCase& test_case, const HuntSpace& space);
std::vector<map::CellAt> cells_with_line(const map::Map& map);

/// Return the contents of files. The map is empty if none is drawn; the robot is empty if it is unchanged.
std::string map_text(const TestCase& test_case, const HuntSpace& space);
std::string robot_text(const TestCase& test_case, const HuntSpace& space);
std::string script_text(const TestCase& test_case, const HuntSpace& space);
/// Returns the length of the lines of a drawn map.
double line_length_m(const TestCase& test_case, const HuntSpace& space);

}  // namespace robosim::campaign
