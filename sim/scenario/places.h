// Places on the floor, as scripts write them. Everything throws InputError for others.
#pragma once

#include <string>

#include "sim/base/vec.h"
#include "sim/grid/map.h"
#include "sim/grid/stripes.h"

namespace robosim::scenario {

/// "COLUMN,ROW"
grid::CellAt parse_cell(const grid::Map& map, const std::string& text);

/// Where a robot is put: on a line cell, "X,Y,DIR"; or anywhere, "352mm,118mm,NE".
Pose parse_place(const grid::Map& map, const grid::Stripes& stripes, const std::string& text);

}  // namespace robosim::scenario
