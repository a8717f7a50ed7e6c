// Stores everything solid that stops bodies: wall and obstacle cells, the area beyond the map's edge, and
// round obstacles placed during a run.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"

namespace robosim::world {

/// A place where an outline meets something solid.
struct Contact {
  Vec2 point;             ///< m, in the world frame
  Vec2 normal;            ///< unit vector, away from the solid
  double depth = 0.0;     ///< m by which the outline overlaps; negative: the remaining gap
  bool embedded = false;  ///< the outline's middle is inside a block of walls, with no open side
};

/// The kinds of solid things. An obstacle is a cell of the map, or a disc.
enum class Solid { wall, obstacle, edge };
/// Returns "a wall", "an obstacle" or "the map's edge".
const char* to_string(Solid solid);

/// The contacts of an outline, deepest first. Stores only the eight deepest.
class Contacts {
 public:
  void add(const Contact&);
  const Contact* begin() const { return found_.data(); }
  const Contact* end() const { return found_.data() + size_; }
  bool empty() const { return size_ == 0; }

 private:
  std::array<Contact, 8> found_;
  std::size_t size_ = 0;
};

/// A round obstacle.
struct Disc {
  int id = 0;
  Vec2 centre;
  double radius_m = 0.0;
};

class Walls {
 public:
  /// Largest gap, m, at which a contact is reported, and an existing contact continues.
  static constexpr double kNear = 0.001;

  /// The map must outlive the walls.
  explicit Walls(const map::Map& map);

  /// Returns a lower bound of the distance from p to the nearest wall, m; 0 inside walls and beyond the edge.
  /// Discs are ignored. If k is the number of rings without walls about p's cell, including this cell, the
  /// bound is
  ///   (k - 1) cell + distance from p to its cell's border
  double clearance(Vec2 p) const {
    const double x = p.x * per_cell_, y = p.y * per_cell_;
    if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_)) return 0.0;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const int rings = rings_[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_->width) +
                             static_cast<std::size_t>(column)];
    const double right = x - column, up = y - row;
    const double border = std::min(std::min(right, 1.0 - right), std::min(up, 1.0 - up));
    return rings == 0 ? 0.0 : (rings - 1 + border) * map_->cell_m;
  }

  /// Returns the contacts of a disc, including solids at a gap of less than kNear.
  Contacts touch(Vec2 centre, double radius) const;
  /// Returns the contacts of a convex polygon, counter-clockwise, in the world frame. The circle of `radius`
  /// about `centre` must contain the polygon.
  Contacts touch(std::span<const Vec2> polygon, Vec2 centre, double radius) const;

  // The next functions return the distance, m, from a point to walls, discs and the map's edge; 0 from inside
  // one of them. Directions are unit vectors. The result is `most` if nothing is nearer.
  /// Returns the distance along a ray.
  double range_along(Vec2 from, Vec2 direction, double most) const;
  /// Returns the distance to the nearest point in a beam. `half_beam` is the cosine and sine of half the
  /// beam's angle; half the angle is less than 60 degrees. The beam extends to both sides of `direction`.
  double range_in_beam(Vec2 from, Vec2 direction, Vec2 half_beam, double most) const;

  int add(Vec2 centre, double radius_m);
  /// remove() and move() do nothing if the obstacle does not exist.
  void remove(int id);
  void move(int id, Vec2 centre);
  std::span<const Disc> discs() const { return state_.discs; }
  /// The state that changes during a run.
  struct State {
    std::vector<Disc> discs;
    int next_id = 1;
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }
  /// Returns the kind of solid to which a contact belongs.
  Solid solid_at(const Contact& contact) const;
  /// Returns whether a disc is less than kNear from the circle.
  bool near_disc(Vec2 centre, double radius) const;

  /// Returns how far a body may move between two checks for walls without passing through a wall, m.
  double stride(double body_radius) const {
    double least = map_->cell_m;
    for (const Disc& disc : state_.discs) least = std::min(least, body_radius + disc.radius_m);
    return 0.25 * least;
  }

 private:
  bool solid(int column, int row) const;  // row from the bottom
  bool beyond_edge(Vec2) const;           // by more than a cell
  void touch_cell(std::span<const Vec2> polygon, int column, int row, Contacts&) const;

  const map::Map* map_;
  const double per_cell_, columns_, rows_;
  std::vector<std::uint8_t> rings_;  // row by row from the bottom; 255 = 255 or more
  State state_;
};

}  // namespace robosim::world
