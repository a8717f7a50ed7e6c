// The paint of lines and marks. [[path]], its segments and [[mark]] may have their own width, colour, wear
// and gloss (docs/reference/maps.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/map/colour.h"

namespace robosim::map {

struct Map;

struct Paint {
  double width = 0.0;            ///< width of a line in m
  std::optional<Colour> colour;  ///< nullopt = the colour of the map's lines, black or white
  double worn = 0.0;             ///< share of the paint that is worn off, in patches, 0..1
  double gloss = 0.0;  ///< specular reflection, relative to the light that white paper returns, 0..1
  bool operator==(const Paint&) const = default;

  /// Maximum number of a course's paints that differ from the map's default.
  static constexpr std::size_t kMost = 32;
};

/// Returns the default paint of the map's lines.
Paint usual_paint(const Map& map);

/// Returns all paints: the default first, then the course's. Stripes and marks refer to them by index. Each
/// paint has a colour.
std::vector<Paint> paints_of(const Map& map);

/// Returns whether all lines and marks have the same paint, unworn and matt.
bool is_plain(const Map& map);

}  // namespace robosim::map
