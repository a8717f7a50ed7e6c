// Parses places on the floor in scripts. All functions throw InputError for invalid places.
#pragma once

#include <string>

#include "sim/base/vec.h"
#include "sim/map/map.h"
#include "sim/map/stripes.h"

namespace robosim::scenario {

/// Parses "COLUMN,ROW".
map::CellAt parse_cell(const map::Map& map, const std::string& text);

/// A line between the centres of two cells in one row or column: "X,Y X,Y".
struct Stretch {
  Vec2 from, to;  ///< m
};
Stretch parse_stretch(const map::Map& map, const std::string& text);

/// Parses a pose of the robot: "X,Y,DIR" for a line cell, or "352mm,118mm,NE" for any place.
Pose parse_place(const map::Map& map, const map::Stripes& stripes, const std::string& text);

}  // namespace robosim::scenario
