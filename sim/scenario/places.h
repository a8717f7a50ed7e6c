// Parses places on the floor in scripts. All functions throw InputError for invalid places.
#pragma once

#include <string>

#include "sim/base/vec.h"
#include "sim/grid/map.h"
#include "sim/grid/stripes.h"

namespace robosim::scenario {

/// Parses "COLUMN,ROW"
grid::CellAt parse_cell(const grid::Map& map, const std::string& text);

/// A line between the centres of two cells in one row or column: "X,Y X,Y".
struct Stretch {
  Vec2 from, to;  ///< m
};
Stretch parse_stretch(const grid::Map& map, const std::string& text);

/// Parses a pose for the robot: on a line cell, "X,Y,DIR"; or anywhere, "352mm,118mm,NE".
Pose parse_place(const grid::Map& map, const grid::Stripes& stripes, const std::string& text);

}  // namespace robosim::scenario
