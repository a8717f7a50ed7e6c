// The paint of lines, where it differs from the map's usual one. [[path]], its segments and [[mark]] may have
// their own width, colour, wear and gloss (docs/reference/maps.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/grid/colour.h"

namespace robosim::grid {

struct Map;

struct Paint {
  double width = 0.0;            ///< m, of a line
  std::optional<Colour> colour;  ///< none: the map's line, black or white
  double worn = 0.0;             ///< the share of it that is gone, in patches, 0..1
  double gloss = 0.0;            ///< what it mirrors, as a share of what white paper sends back, 0..1
  bool operator==(const Paint&) const = default;

  /// The limit of paints of a course that differ from the map's.
  static constexpr std::size_t kMost = 32;
};

/// Returns the default paint of the map's lines.
Paint usual_paint(const Map& map);

/// Returns the paints by the numbers in stripes and marks: first the default, then those of the course. Each
/// has a colour.
std::vector<Paint> paints_of(const Map& map);

/// Returns whether all lines and marks have the same paint, unworn and matt.
bool is_plain(const Map& map);

}  // namespace robosim::grid
