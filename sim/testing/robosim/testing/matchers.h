// What a drive is expected to be: EXPECT_THAT(robot.run_for(20_s), Follows(line(), within(15_mm))).
//
// Each takes a Drive or a whole Simulation (all that has happened so far), and combines with Not(), AllOf()
// and AnyOf(). A failure says what happened, when and where, what happened before, and the command that
// replays it.
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

/// A requirement on a drive: a sentence, and what is wrong.
class Requirement {
 public:
  /// What a drive has that it should not, or lacks.
  struct Finding {
    bool holds = true;
    std::string sentence;  ///< what was found, either way; may be empty if it holds
    Duration when{};       ///< of what was found
  };
  using Look = std::function<Finding(const Drive&)>;

  /// `holds` and `fails` as in "follows the line within 15 mm", "does not follow …".
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

/// What is followed; there is one line.
struct Line {};
inline Line line() { return {}; }

/// It drove, and the midpoint of its line sensors was never farther from the nearest centre line. Every
/// millisecond counts.
Requirement Follows(Line, Within<Length> within);

/// It came to all these stations, in any order.
Requirement Visits(std::initializer_list<int> stations);
Requirement Visits(std::vector<std::string> stations);
/// It came to just these stations, in this order. Leaving one and coming back counts twice; the one at which
/// the drive began does not count unless it comes back.
Requirement VisitsInOrder(std::initializer_list<int> stations);

/// Counted from the drive's beginning: after this time, or this length of way, no wheel turns until its end.
Requirement StopsWithin(Duration time);
Requirement StopsWithin(Length way);

/// What a robot may be doing at a moment.
struct Doing {
  std::string clause;  ///< "backwards"
  std::function<bool(const Moment& before, const Moment& now)> is;
};
Doing at_all();        ///< a motor is commanded
Doing backwards();     ///< faster than 5 mm/s
Doing off_the_line();  ///< no line sensor sees it
Doing faster_than(Speed speed);
Doing onto(int column, int row);  ///< the axle's centre is over this cell
/// Looked at every 10 ms.
Requirement NeverDrives(Doing what);
/// No contact with walls, obstacles or the map's edge.
Requirement NeverCollides();

/// The sketch has sent this text, or a line in which this regular expression is found.
Requirement SerialSays(std::string text);
Requirement SerialMatches(std::string regex);

/// The run ended by itself, with the goal reached. `goal` as in Trial.
Requirement Reaches(std::string goal);
/// The run ended with this verdict: "lost".
Requirement EndsAs(std::string verdict);

/// The run ended, and a competition's rules gave it at least, or at most, so much: seconds or points.
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
/// From power-on to the drive's end. Chips only: on the host nothing of this is known, and it fails.
Requirement UsesAtMost(std::initializer_list<Limit> limits);
template <typename... Limits>
Requirement UsesAtMost(Limit first, Limits... more) {
  return UsesAtMost({first, more...});
}

}  // namespace robosim::testing
