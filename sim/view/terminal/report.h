// Formats the final screen of a run: its result at a glance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"
#include "sim/view/terminal/frame.h"
#include "sim/wire/hand.h"
#include "sim/wire/messages.h"

namespace robosim::terminal {

class FloorPicture;

/// The robot's path, sampled evenly. The spacing grows with the number of samples, so that memory stays
/// bounded.
class Trail {
 public:
  void add(const wire::Sample& sample);
  /// Adds a note. A manual move leaves no trail.
  void add(const wire::Note& note) { hand_.add(note); }
  const std::vector<Vec2>& points() const { return points_; }  ///< m, world frame
  void draw(FloorPicture& floor) const;
  /// Returns whether the robot was moved manually to the position of the last sample.
  bool was_carried() const { return carried_; }
  bool empty() const { return points_.empty(); }
  Vec2 last() const { return last_; }
  double yaw_rad() const { return yaw_rad_; }

 private:
  std::vector<Vec2> points_;
  std::vector<bool> gaps_;  ///< per point: whether the robot was moved manually just before this point
  bool gap_ = false;        ///< whether the robot was moved manually since the last point
  bool carried_ = false;
  wire::Hand hand_;
  Vec2 last_;
  double yaw_rad_ = 0.0;
  std::size_t every_ = 1, seen_ = 0;
};

/// Returns the sample period for a run of at most `for_ns`. The period is coarse enough to cost nothing, and
/// fine enough for a picture with a few centimetres per dot. It is a multiple of 1 ms.
std::int64_t trail_every_ns(std::int64_t for_ns);

/// A capacity that the firmware states, and the largest capacity for which the RAM would suffice.
struct Room {
  std::string what;  ///< "nodes of a tree"
  std::uint64_t now = 0;
  std::uint64_t fit = 0;  ///< the capacity that would use up the RAM left by the deepest stack
  std::uint64_t bytes_each = 0;
};

/// The data of a report.
struct Report {
  std::string sketch;  ///< as the user named it
  std::string map;
  std::string robot;
  std::string target;
  wire::Started started;
  result::RunResult result;
  Trail trail;
  std::optional<double> wall_s;  ///< empty = not shown
  std::vector<Room> rooms;
  std::string chip_target;  ///< the target with the chip of the robot's board
  bool sees_lines = true;   ///< the robot has line sensors
  std::string board = {};   ///< name of the robot's board; empty = unknown
  std::uint64_t chip_ram_bytes = 0;
};

/// Returns the screen: at most 20 rows of picture, and `columns` characters per line. Without a `map` (null)
/// there is no picture.
std::string end_screen(const Report& report, const map::Map* map, int columns, Look look);

/// Returns marks for the stations and the beginning of the trail, or the start's cell if there is no trail.
/// The marks of visited stations have the ink `good`.
struct Mark;
std::vector<Mark> floor_marks(const map::Map& map, const wire::Started& started, const Trail& trail,
                              const std::vector<std::string>& visited);

}  // namespace robosim::terminal
