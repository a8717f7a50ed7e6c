// Draws a map with paths for a terminal: its floor in braille dots.
#pragma once

#include <string>

#include "sim/grid/map.h"
#include "sim/grid/picture.h"

namespace robosim::cli {

/// Returns the floor, an arrow at the start, and a legend.
std::string draw_course(const grid::Map& map, const grid::Start& start, const grid::PictureOptions& options);

}  // namespace robosim::cli
