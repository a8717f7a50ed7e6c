// Represents the part of a run between two moments. Matchers check this part.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robosim/testing/quantities.h"

namespace robosim::testing {

/// The robot's pose. x (east) and y (north) are the position of the axle's centre, from the map's bottom-left
/// corner. yaw is counter-clockwise from east. Columns and rows count from 0 at the map's top left.
struct Pose {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double yaw_rad = 0.0;
  int column = 0;
  int row = 0;
};

/// The robot's state at a moment. A moment is recorded every 10 ms.
struct Moment {
  Duration t{};
  Pose pose;
  Speed speed;            ///< forward
  Length cross_track;     ///< distance from the midpoint of the line sensors to the nearest centre line
  double left = 0.0;      ///< motor command, -1..1
  double right = 0.0;     ///< motor command, -1..1
  bool off_line = false;  ///< no line sensor sees any line
  std::string station;    ///< the station whose centre the body covers; "" = none
  std::vector<double> readings;
};

/// The chip's resources that the firmware uses.
struct Usage {
  std::int64_t flash_bytes = 0;
  std::int64_t ram_bytes = 0;    ///< variables
  std::int64_t stack_bytes = 0;  ///< maximum, including interrupt handlers
  Duration longest_loop{};       ///< 0 = unknown
  std::int64_t free_bytes = 0;   ///< RAM that variables, heap and stack never used
};

/// A run's score under the rules of a goal such as "robotrace".
struct Score {
  /// One item of the score: "gap", 3 times, 30 points in all.
  struct Part {
    std::string what;
    int count = 0;
    double value = 0.0;  ///< total value
  };
  double value = 0.0;
  std::string unit;  ///< "s" (less is better) or "points"
  std::vector<Part> parts;
};

struct RunLog;

class Drive {
 public:
  Drive(std::shared_ptr<const RunLog> log, Duration begin, Duration end);

  Duration begin() const { return begin_; }
  Duration end() const { return end_; }

  /// Returns whether the awaited event has occurred. After run_for(), returns whether the run lasted for the
  /// whole duration.
  bool arrived() const { return complaint_.empty(); }
  explicit operator bool() const { return arrived(); }
  /// Converts for ASSERT_TRUE and EXPECT_TRUE. Includes the reason for a failure.
  operator ::testing::AssertionResult() const;  // NOLINT(google-explicit-constructor)

  /// Returns the text that the sketch has sent during this drive.
  std::string serial() const;
  /// Returns the drive's moments, in order of time. The first moment is the beginning of the drive.
  std::vector<Moment> moments() const;
  /// Returns the stations in the order of arrival. A station that the robot left and visited again is listed
  /// twice.
  std::vector<std::string> stations() const;
  /// Returns the moment at which the robot was farthest from the line.
  Moment worst() const;
  Length distance() const;
  int collisions() const;
  /// Returns the verdict with which the run ended: "lost", "reached", …; else "".
  std::string verdict() const;
  /// Returns one sentence that explains the verdict, if the run has ended.
  std::string why() const;
  /// Returns the score under a competition's rules (docs/reference/courses.md). Returns nullopt if the run
  /// has not ended, or if its goal has no score.
  std::optional<Score> score() const;
  /// Returns the resources used until now. Available only on a chip.
  std::optional<Usage> usage() const;

  /// Returns lines for messages: the last events before `until`, the robot's position at the end, and the
  /// command that replays the run.
  std::string epilogue(Duration until) const;
  /// Returns "PidFollower on oval (uno5, target host, seed 3), 0.00 s to 20.00 s".
  std::string title() const;
  const RunLog& log() const { return *log_; }

  void fail_with(std::string complaint) { complaint_ = std::move(complaint); }

 private:
  std::shared_ptr<const RunLog> log_;
  Duration begin_, end_;
  std::string complaint_;
};

void PrintTo(const Drive& drive, std::ostream* out);

}  // namespace robosim::testing
