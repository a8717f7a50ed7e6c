// Draws a map as text for a terminal.
#pragma once

#include <string>

#include "sim/map/map.h"
#include "sim/map/network.h"

namespace robosim::map {

struct PictureOptions {
  int columns = 100;   ///< maximum number of characters per line
  int rows = 200;      ///< maximum number of lines, including the rulers
  bool ascii = false;  ///< use only ASCII characters
};

/// Draws lines as box-drawing characters, stations as numbers, and the start as an arrow. Adds rulers with
/// column and row numbers, and a legend. A cell is two characters wide if the map fits, else one. A map that
/// is too large is clipped to a part around the start. A sentence below the picture reports this.
std::string draw(const Map& map, const Network& network, const Start& start, const PictureOptions& options);

}  // namespace robosim::map
