// Draws a map as text for a terminal.
#pragma once

#include <string>

#include "sim/grid/map.h"
#include "sim/grid/network.h"

namespace robosim::grid {

struct PictureOptions {
  int columns = 100;   ///< characters a line may have
  int rows = 200;      ///< lines the picture may have, its rulers included
  bool ascii = false;  ///< no characters beyond ASCII
};

/// Draws lines as box drawing, with station numbers and an arrow at the start. Adds rulers with column and
/// row numbers, and a legend. A cell takes two characters if that fits, else one. A map that is too large
/// is clipped to a part around the start, and a sentence reports that.
std::string draw(const Map& map, const Network& network, const Start& start, const PictureOptions& options);

}  // namespace robosim::grid
