// A bend: a line cell with two neighbours at a right angle, and the radius of its arc. An implementation
// detail of Stripes.
#pragma once

#include <optional>

#include "sim/map/map.h"

namespace robosim::map {

struct Corner {
  CellAt cell;
  Direction first;    ///< first leg; the arc runs counter-clockwise from it to the second
  Direction second;   ///< second leg: `first` turned right
  double radius = 0;  ///< m; 0 = square

  /// Returns the distance along a leg from the corner to the arc's middle: (1 - 1/sqrt 2) radius.
  double middle() const { return radius * 0.29289321881345243; }
};

/// Returns the bend at a cell, or nullopt. Takes time proportional to the length of the legs, up to twice the
/// corner radius.
std::optional<Corner> corner_at(const Map& map, CellAt cell);

/// Returns the bend whose arc replaces the centre of a line cell, if any.
std::optional<Corner> corner_over(const Map& map, CellAt cell);

/// Returns whether the legs are too short for the map's corner radius.
bool is_tight(const Map& map, const Corner& corner);

}  // namespace robosim::map
