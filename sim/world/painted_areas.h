// Models rectangles and discs painted on the floor: [[area]] of a map.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/map/map.h"
#include "sim/world/visibility_grid.h"

namespace robosim::world {

/// The band of light that a sensor measures.
enum class Band { infrared, red, green, blue };

/// Returns a colour's reflectance in a band, relative to white.
inline double sent_back(const map::Colour& colour, Band band) {
  return band == Band::infrared ? colour.infrared() : colour.light(static_cast<std::size_t>(band) - 1);
}

class PaintedAreas {
 public:
  explicit PaintedAreas(const map::Map& map);

  bool empty() const { return areas_.empty(); }

  /// Returns the reflectance in a band, relative to white, of a square of side `footprint` about p.
  /// Only areas with the given `over_lines` count; `below` is the reflectance under them. Later areas cover
  /// earlier ones. The share of the square that an area covers is exact for a rectangle parallel to the
  /// square. A disc's edge is treated as straight.
  double over(double below, bool over_lines, Band band, Vec2 p, double footprint) const {
    return areas_.empty() ? below : over_any(below, over_lines, band, p, footprint);
  }

 private:
  double over_any(double below, bool over_lines, Band band, Vec2 p, double footprint) const;

  std::vector<map::Area> areas_;
  VisibilityGrid near_;
};

}  // namespace robosim::world
