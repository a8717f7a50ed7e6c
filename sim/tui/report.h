// The final screen of a run: its result at a glance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/vec.h"
#include "sim/grid/map.h"
#include "sim/tui/frame.h"
#include "sim/wire/hand.h"
#include "sim/wire/messages.h"

namespace robosim::tui {

class FloorPicture;

/// The robot's path, sampled evenly. With more events the spacing grows, so that memory stays bounded.
class Trail {
 public:
  void add(const wire::Sample& sample);
  /// A manual move leaves no trail.
  void add(const wire::Note& note) { hand_.add(note); }
  const std::vector<Vec2>& points() const { return points_; }  ///< m, world frame
  void draw(FloorPicture& floor) const;
  /// Returns whether the robot was moved manually to the last sample's place.
  bool was_carried() const { return carried_; }
  bool empty() const { return points_.empty(); }
  Vec2 last() const { return last_; }
  double yaw_rad() const { return yaw_rad_; }

 private:
  std::vector<Vec2> points_;
  std::vector<bool> gaps_;  ///< whether it was moved manually on the way to each of them
  bool gap_ = false;        ///< whether it was moved manually since the last of them
  bool carried_ = false;
  wire::Hand hand_;
  Vec2 last_;
  double yaw_rad_ = 0.0;
  std::size_t every_ = 1, seen_ = 0;
};

/// Returns the sample period for a run of that maximum duration. It is coarse enough to cost nothing, fine
/// enough for a picture with a few centimetres per dot. A multiple of 1 ms.
std::int64_t trail_every_ns(std::int64_t for_ns);

/// A limit that the firmware states, and its possible maximum.
struct Room {
  std::string what;  ///< "nodes of a tree"
  std::uint64_t now = 0;
  std::uint64_t fit = 0;  ///< the number that would take all RAM left by the deepest stack
  std::uint64_t bytes_each = 0;
};

/// The data of a report.
struct Report {
  std::string sketch;  ///< as the user named it
  std::string map;
  std::string robot;
  std::string target;
  wire::Started started;
  wire::RunResult result;
  Trail trail;
  std::optional<double> wall_s;  ///< empty = not shown
  /// On a chip: RAM that neither variables nor the deepest stack used.
  std::optional<std::int64_t> free_bytes;
  std::vector<Room> rooms;
  std::string chip_target;  ///< the target whose chip the robot's board has
  bool sees_lines = true;   ///< the robot has sensors for them
  std::string board = {};   ///< board of the robot, by name; empty = not known
  std::uint64_t chip_ram_bytes = 0;
};

/// Returns at most 20 rows of picture and `columns` characters per line. `map` may be null: then there is no
/// picture.
std::string end_screen(const Report& report, const grid::Map* map, int columns, Look look);

/// Stations, and the beginning of the trail (without one the start's cell); visited stations in another ink.
struct Mark;
std::vector<Mark> floor_marks(const grid::Map& map, const wire::Started& started, const Trail& trail,
                              const std::vector<std::string>& visited);

}  // namespace robosim::tui
