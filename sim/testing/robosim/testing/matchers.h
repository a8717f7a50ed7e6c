// Defines matchers for drives: EXPECT_THAT(robot.run_for(20_s), Follows(line(), within(15_mm))).
//
// Each matcher accepts a Drive or a whole Simulation (everything so far), and combines with Not(), AllOf()
// and AnyOf(). A failure prints the finding with its time and place, the events before it, and the command
// that replays the run.
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "robosim/testing/drive.h"
#include "robosim/testing/quantities.h"
#include "robosim/testing/simulation.h"

namespace robosim::testing {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Not;

/// A requirement on a drive: a sentence, and a check.
class Requirement {
 public:
  /// The result of a check.
  struct Finding {
    bool holds = true;
    std::string sentence;  ///< describes the finding; may be empty if the requirement holds
    Duration when{};       ///< time of the finding
  };
  using Look = std::function<Finding(const Drive&)>;

  /// Makes a requirement. `holds` and `fails` are clauses: "follows the line within 15 mm", "does not follow
  /// …".
  Requirement(std::string holds, std::string fails, Look look)
      : holds_(std::move(holds)), fails_(std::move(fails)), look_(std::move(look)) {}

  using is_gtest_matcher = void;
  bool MatchAndExplain(const Drive& drive, std::ostream* out) const;
  bool MatchAndExplain(const Simulation& simulation, std::ostream* out) const {
    return MatchAndExplain(simulation.so_far(), out);
  }
  void DescribeTo(std::ostream* out) const;
  void DescribeNegationTo(std::ostream* out) const;

 private:
  std::string holds_, fails_;
  Look look_;
};

/// The line to follow.
struct Line {};
inline Line line() { return {}; }

/// Requires that the robot drove, and that the midpoint of its line sensors stayed near the line. In every
/// millisecond, the midpoint must be within this distance of the nearest centre line.
Requirement Follows(Line, Within<Length> within);

/// Requires that the robot visited all these stations, in any order.
Requirement Visits(std::initializer_list<int> stations);
Requirement Visits(std::vector<std::string> stations);
/// Requires that the robot visited exactly these stations, in this order. A station that the robot leaves and
/// visits again counts twice. The station at which the drive began counts only if the robot returns.
Requirement VisitsInOrder(std::initializer_list<int> stations);

/// Require that the robot does not move after this time, or after this distance, both counted from the
/// drive's beginning.
Requirement StopsWithin(Duration time);
Requirement StopsWithin(Length way);

/// An activity of a robot at one moment.
struct Doing {
  std::string clause;  ///< "backwards"
  std::function<bool(const Moment& before, const Moment& now)> is;
};
Doing at_all();        ///< a motor is commanded
Doing backwards();     ///< faster than 5 mm/s
Doing off_the_line();  ///< no line sensor sees the line
Doing faster_than(Speed speed);
Doing onto(int column, int row);  ///< the axle's centre is over this cell
/// Requires that the robot never does `what`. Example: NeverDrives(backwards()). Checks a sample every 10 ms.
Requirement NeverDrives(Doing what);
/// Requires no contact with walls, obstacles, the map's edge or other robots.
Requirement NeverCollides();

/// SerialSays() requires that the sketch has sent this text. SerialMatches() requires that the regular
/// expression matches part of a line that the sketch has sent.
Requirement SerialSays(std::string text);
Requirement SerialMatches(std::string regex);

/// Requires that the run ended by itself and reached the goal. `goal` has the form of Trial::goal.
Requirement Reaches(std::string goal);
/// Requires that the run ended with this verdict: "lost".
Requirement EndsAs(std::string verdict);

/// ScoresAtLeast() requires that the run ended with a score of at least `value`. ScoresAtMost() requires a
/// score of at most `value`. The unit is seconds or points.
Requirement ScoresAtLeast(double value);
Requirement ScoresAtMost(double value);

/// Limits for UsesAtMost.
struct Limit {
  enum class Of { flash, ram, stack, loop_time } of;
  std::int64_t most;  ///< bytes, or ns
};
constexpr Limit flash(std::int64_t bytes) { return {Limit::Of::flash, bytes}; }
constexpr Limit ram(std::int64_t bytes) { return {Limit::Of::ram, bytes}; }  ///< variables
constexpr Limit stack(std::int64_t bytes) { return {Limit::Of::stack, bytes}; }
constexpr Limit loop_time(Duration most) { return {Limit::Of::loop_time, most.count()}; }
/// Requires that the firmware stayed within these limits from power-on to the drive's end. For chip targets
/// only: on the host the values are unknown, and the requirement fails.
Requirement UsesAtMost(std::initializer_list<Limit> limits);
template <typename... Limits>
Requirement UsesAtMost(Limit first, Limits... more) {
  return UsesAtMost({first, more...});
}

}  // namespace robosim::testing
