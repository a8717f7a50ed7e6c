// The end-of-run screen: what happened, at a glance.
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

/// Where the robot was, sampled evenly. As events come in, the spacing grows so that memory stays bounded.
class Trail {
 public:
  void add(const wire::Sample& sample);
  /// A hand that moves the robot leaves no trail.
  void add(const wire::Note& note) { hand_.add(note); }
  const std::vector<Vec2>& points() const { return points_; }  ///< m, world frame
  void draw(FloorPicture& floor) const;
  /// Whether the last sample's place was not driven to.
  bool was_carried() const { return carried_; }
  bool empty() const { return points_.empty(); }
  Vec2 last() const { return last_; }
  double yaw_rad() const { return yaw_rad_; }

 private:
  std::vector<Vec2> points_;
  std::vector<bool> gaps_;  ///< whether it was carried on the way to each of them
  bool gap_ = false;        ///< or since
  bool carried_ = false;
  wire::Hand hand_;
  Vec2 last_;
  double yaw_rad_ = 0.0;
  std::size_t every_ = 1, seen_ = 0;
};

/// How often it wants a sample of a run that may last so long: coarse enough to cost nothing, fine enough for
/// a picture of a few centimetres a dot. A multiple of 1 ms.
std::int64_t trail_every_ns(std::int64_t for_ns);

/// A limit that the firmware states, and how far it could be raised.
struct Room {
  std::string what;  ///< "nodes of a tree"
  std::uint64_t now = 0;
  std::uint64_t fit = 0;  ///< so many would take all RAM that the deepest stack has left
  std::uint64_t bytes_each = 0;
};

/// What a report is made of.
struct Report {
  std::string sketch;  ///< as the user named it
  std::string map;
  std::string robot;
  std::string target;
  wire::Started started;
  wire::RunResult result;
  Trail trail;
  std::optional<double> wall_s;  ///< empty = not shown
  /// On a chip: RAM that neither variables nor the deepest stack took.
  std::optional<std::int64_t> free_bytes;
  std::vector<Room> rooms;
  std::string chip_target;  ///< the target whose chip the robot's board has
  bool sees_lines = true;   ///< the robot has sensors for them
};

/// At most 20 rows of picture and `columns` characters a line. `map` may be null: then there is no picture.
std::string end_screen(const Report& report, const grid::Map* map, int columns, Look look);

/// Stations, and where the trail begins (without one the start's cell); visited stations in another ink.
struct Mark;
std::vector<Mark> floor_marks(const grid::Map& map, const wire::Started& started, const Trail& trail,
                              const std::vector<std::string>& visited);

}  // namespace robosim::tui
