// Draws a map for a terminal: its floor in braille dots.
#pragma once

#include <string>

#include "sim/map/map.h"
#include "sim/map/picture.h"

namespace robosim::cli {

/// Returns the floor, an arrow at the start, and a legend.
std::string draw_course(const map::Map& map, const map::Start& start, const map::PictureOptions& options);

}  // namespace robosim::cli
