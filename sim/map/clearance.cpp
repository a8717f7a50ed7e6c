#include "sim/map/clearance.h"

#include <algorithm>
#include <cmath>

namespace robosim::map {
namespace {

constexpr double kStep = 0.005;  // m

// Returns the distance from a point to a square, given by its lower left corner and its side.
double to_square(Vec2 p, Vec2 corner, double side) {
  const double dx = std::max({corner.x - p.x, 0.0, p.x - corner.x - side});
  const double dy = std::max({corner.y - p.y, 0.0, p.y - corner.y - side});
  return std::hypot(dx, dy);
}

// Searches for a wall or an edge nearer to `p` than `least`, and updates `least` and `found`.
void look_around(const Map& map, Vec2 p, int path, double& least, std::optional<Narrowest>& found) {
  const double side = map.cell_m;
  const CellAt at{static_cast<int>(std::floor(p.x / side)),
                  map.height - 1 - static_cast<int>(std::floor(p.y / side))};
  const auto take = [&](double room, bool is_edge) {
    if (room >= least) return;
    least = room;
    found = {path, room, at, is_edge};
  };
  take(std::max(std::min({p.x, p.y, map.width * side - p.x, map.height * side - p.y}), 0.0), true);
  const int reach = static_cast<int>(std::ceil(least / side));
  for (int y = std::max(at.y - reach, 0); y <= std::min(at.y + reach, map.height - 1); ++y)
    for (int x = std::max(at.x - reach, 0); x <= std::min(at.x + reach, map.width - 1); ++x)
      if (map.at({x, y}) == Cell::wall)
        take(to_square(p, {x * side, (map.height - 1 - y) * side}, side), false);
}

}  // namespace

std::optional<Narrowest> narrowest(const Map& map, double within) {
  std::optional<Narrowest> found;
  double least = within;
  for (std::size_t i = 0; i < map.course.paths.size(); ++i)
    for (const PathPiece& piece : map.course.paths[i].pieces()) {
      const int steps = static_cast<int>(std::ceil(piece.length / kStep));
      for (int k = 0; k <= steps; ++k)
        look_around(map, piece.at(steps > 0 ? piece.length * k / steps : 0.0).position, static_cast<int>(i),
                    least, found);
    }
  return found;
}

}  // namespace robosim::map
