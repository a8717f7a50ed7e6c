// Models rectangles and discs painted on the floor: [[area]] of a map.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/map/map.h"
#include "sim/world/visibility_grid.h"

namespace robosim::world {

/// The band of a sensor: reflected infra-red, red, green or blue.
enum class Band { infrared, red, green, blue };

/// Returns a colour's reflectance in a band, relative to white.
inline double sent_back(const map::Colour& colour, Band band) {
  return band == Band::infrared ? colour.infrared() : colour.light(static_cast<std::size_t>(band) - 1);
}

class PaintedAreas {
 public:
  explicit PaintedAreas(const map::Map& map);

  bool empty() const { return areas_.empty(); }

  /// Returns the reflectance of a band, as a share of white's, in a square of side `footprint` about p.
  /// Only areas with the given `over_lines` count; `below` is the reflectance under them. Each area covers
  /// the previous ones. The share of the square that an area covers is exact for a parallel rectangle. A
  /// disc's edge is treated as straight.
  double over(double below, bool over_lines, Band band, Vec2 p, double footprint) const {
    return areas_.empty() ? below : over_any(below, over_lines, band, p, footprint);
  }

 private:
  double over_any(double below, bool over_lines, Band band, Vec2 p, double footprint) const;

  std::vector<map::Area> areas_;
  VisibilityGrid near_;
};

}  // namespace robosim::world
