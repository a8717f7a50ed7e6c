// A map as text for a terminal.
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

/// Lines as box drawing, station numbers, an arrow at the start, rulers with column and row numbers, and
/// below it a line that explains the signs used. A cell takes two characters if that fits, else one. A map
/// that is too large is clipped to a part around the start, and a sentence says so.
std::string draw(const Map& map, const Network& network, const Start& start, const PictureOptions& options);

}  // namespace robosim::grid
