#include "sim/map/corner.h"

#include <algorithm>

namespace robosim::map {
namespace {

constexpr double kAlmost = 1.0 - 1e-9;  // prevents rounding from making a bend tight

unsigned bit(Direction d) { return 1u << static_cast<int>(d); }

// Returns the first leg of the bend that these line neighbours form, if any.
std::optional<Direction> first_leg(unsigned lines) {
  for (const Direction d : {Direction::east, Direction::south, Direction::west, Direction::north})
    if (lines == (bit(d) | bit(turned_right(d)))) return d;
  return std::nullopt;
}

bool is_straight(unsigned lines, Direction d) { return lines == (bit(d) | bit(reversed(d))); }

// Returns the length of a leg that an arc may use, at most the corner radius. Two bends share the leg between
// them equally.
double room(const Map& map, CellAt corner, Direction d) {
  CellAt cell = corner;
  for (int n = 1;; ++n) {
    const double leg = n * map.cell_m;
    if (leg / 2 >= map.corner_m * kAlmost) return map.corner_m;
    cell = ahead(cell, d);
    const unsigned lines = line_neighbours(map, cell);
    if (is_straight(lines, d)) continue;
    const double share = first_leg(lines) ? leg / 2 : leg;
    return share >= map.corner_m * kAlmost ? map.corner_m : share;
  }
}

}  // namespace

std::optional<Corner> corner_at(const Map& map, CellAt cell) {
  if (!is_line(map.at(cell))) return std::nullopt;
  const auto first = first_leg(line_neighbours(map, cell));
  if (!first) return std::nullopt;
  Corner corner{cell, *first, turned_right(*first)};
  if (map.corner_m > 0.0)
    corner.radius = std::min(room(map, cell, corner.first), room(map, cell, corner.second));
  return corner;
}

std::optional<Corner> corner_over(const Map& map, CellAt cell) {
  if (map.corner_m <= 0.0) return std::nullopt;
  if (auto corner = corner_at(map, cell)) return corner;
  const unsigned lines = line_neighbours(map, cell);
  for (const Direction d : {Direction::east, Direction::south, Direction::west, Direction::north}) {
    if (!is_straight(lines, d)) continue;
    CellAt corner_cell = cell;
    for (int n = 1; n * map.cell_m < map.corner_m; ++n) {
      corner_cell = ahead(corner_cell, d);
      if (is_straight(line_neighbours(map, corner_cell), d)) continue;
      const auto corner = corner_at(map, corner_cell);
      if (corner && n * map.cell_m < corner->radius) return corner;
      break;
    }
  }
  return std::nullopt;
}

bool is_tight(const Map& map, const Corner& corner) { return corner.radius < map.corner_m; }

}  // namespace robosim::map
