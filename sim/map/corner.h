// Finds the bends of a map's lines. A bend is a line cell with two neighbours at a right angle. Its legs are
// the two straight lines that leave the cell. This header is an implementation detail of Stripes.
#pragma once

#include <optional>

#include "sim/map/map.h"

namespace robosim::map {

struct Corner {
  CellAt cell;
  Direction first;    ///< direction of the first leg; the arc runs counter-clockwise from this leg
  Direction second;   ///< direction of the second leg: `first` turned right
  double radius = 0;  ///< radius of the arc in m; 0 = square

  /// Returns the distance along a leg from the corner to the arc's middle: (1 - 1/sqrt 2) radius.
  double middle() const { return radius * 0.29289321881345243; }
};

/// Returns the bend at a cell, or nullopt. Takes time proportional to the length of the legs, up to twice the
/// corner radius.
std::optional<Corner> corner_at(const Map& map, CellAt cell);

/// Returns the bend whose arc replaces the straight line through a cell's centre, if there is one.
std::optional<Corner> corner_over(const Map& map, CellAt cell);

/// Returns whether the bend's legs are too short for the map's corner radius.
bool is_tight(const Map& map, const Corner& corner);

}  // namespace robosim::map
