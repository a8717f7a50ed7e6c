// A map with paths as text for a terminal: its floor in braille dots.
#pragma once

#include <string>

#include "sim/grid/map.h"
#include "sim/grid/picture.h"

namespace robosim::cli {

/// The floor, an arrow at the start, and a line that explains it.
std::string draw_course(const grid::Map& map, const grid::Start& start, const grid::PictureOptions& options);

}  // namespace robosim::cli
