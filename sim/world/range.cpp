// Computes distances along rays and in beams, as distance sensors measure them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/world/range_of_disc.h"
#include "sim/world/walls.h"
#include "sim/world/world.h"

namespace robosim::world {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// The two edges of a beam.
struct Edges {
  Vec2 left, right;
  Edges(Vec2 direction, Vec2 half_beam)
      : left(direction * half_beam.x + left_of(direction) * half_beam.y),
        right(direction * half_beam.x - left_of(direction) * half_beam.y) {}
  /// Returns whether `d`, seen from the beam's apex, is inside the beam. The apex itself is inside.
  bool hold(Vec2 d) const { return cross(right, d) >= 0.0 && cross(d, left) >= 0.0; }
};

}  // namespace

double range_to_disc(Vec2 from, Vec2 direction, Vec2 centre, double radius) {
  const Vec2 to = centre - from;
  const double ahead = dot(to, direction), aside = cross(direction, to);
  const double square = radius * radius - aside * aside;
  if (dot(to, to) <= radius * radius) return 0.0;
  return ahead > 0.0 && square >= 0.0 ? ahead - std::sqrt(square) : kEndless;
}

double range_to_disc(Vec2 from, Vec2 direction, Vec2 half_beam, Vec2 centre, double radius) {
  const Edges edges(direction, half_beam);
  const Vec2 to = centre - from;
  if (edges.hold(to)) return std::max(length(to) - radius, 0.0);
  return std::min(range_to_disc(from, edges.left, centre, radius),
                  range_to_disc(from, edges.right, centre, radius));
}

// Steps along the ray from one cell border to the next.
double Walls::range_along(Vec2 from, Vec2 direction, double most) const {
  if (beyond_edge(from)) return 0.0;
  const double side = map_->cell_m;
  int column = static_cast<int>(std::floor(from.x * per_cell_));
  int row = static_cast<int>(std::floor(from.y * per_cell_));
  const int step_x = direction.x > 0.0 ? 1 : -1, step_y = direction.y > 0.0 ? 1 : -1;
  double way = 0.0;
  while (way < most && !solid(column, row)) {
    const double to_x =
        direction.x == 0.0 ? kEndless : ((column + (step_x > 0)) * side - from.x) / direction.x;
    const double to_y = direction.y == 0.0 ? kEndless : ((row + (step_y > 0)) * side - from.y) / direction.y;
    if (to_x < to_y) {
      column += step_x;
      way = std::max(to_x, 0.0);
    } else {
      row += step_y;
      way = std::max(to_y, 0.0);
    }
  }
  for (const Disc& disc : state_.discs)
    way = std::min(way, range_to_disc(from, direction, disc.centre, disc.radius_m));
  return std::min(way, most);
}

// Searches for each solid's nearest point in the beam. All solids are convex. If a solid's nearest point is
// outside the beam, its nearest point inside is therefore on an edge of the beam.
double Walls::range_in_beam(Vec2 from, Vec2 direction, Vec2 half_beam, double most) const {
  const Edges edges(direction, half_beam);
  double nearest =
      std::min(range_along(from, direction, most),
               std::min(range_along(from, edges.left, most), range_along(from, edges.right, most)));
  const double reach = nearest / half_beam.x;  // side of a triangle that contains the beam up to `nearest`
  const Vec2 a = from + edges.left * reach, b = from + edges.right * reach;
  const double side = map_->cell_m;
  const auto cell = [&](double x, double cells) {
    return static_cast<int>(std::floor(std::clamp(x * per_cell_, -1.0, cells)));
  };
  const int first = cell(std::min(from.x, std::min(a.x, b.x)), columns_);
  const int last = cell(std::max(from.x, std::max(a.x, b.x)), columns_);
  const int bottom = cell(std::min(from.y, std::min(a.y, b.y)), rows_);
  const int top = cell(std::max(from.y, std::max(a.y, b.y)), rows_);
  for (int row = bottom; row <= top; ++row) {
    for (int column = first; column <= last; ++column) {
      if (!solid(column, row)) continue;
      const double x0 = column * side, y0 = row * side;
      const Vec2 d = Vec2{std::clamp(from.x, x0, x0 + side), std::clamp(from.y, y0, y0 + side)} - from;
      if (edges.hold(d)) nearest = std::min(nearest, length(d));
    }
  }
  for (const Disc& disc : state_.discs)
    nearest = std::min(nearest, range_to_disc(from, direction, half_beam, disc.centre, disc.radius_m));
  return nearest;
}

double World::range_along(std::size_t from_body, Vec2 from, Vec2 direction, double most) const {
  double way = walls_.range_along(from, direction, most);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (i != from_body && !bodies_[i]->lifted())
      way = std::min(way,
                     range_to_disc(from, direction, bodies_[i]->circle_centre(), bodies_[i]->bound_radius()));
  return way;
}

double World::range_in_beam(std::size_t from_body, Vec2 from, Vec2 direction, Vec2 half_beam,
                            double most) const {
  double nearest = walls_.range_in_beam(from, direction, half_beam, most);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (i != from_body && !bodies_[i]->lifted())
      nearest = std::min(nearest, range_to_disc(from, direction, half_beam, bodies_[i]->circle_centre(),
                                                bodies_[i]->bound_radius()));
  return nearest;
}

}  // namespace robosim::world
