// Writes a map as a file that read_map reads back: floor `_`, line `.`, wall `#`, and front matter for
// everything that is not the default.
#pragma once

#include <string>

#include "sim/map/map.h"

namespace robosim::map {

/// Returns the text of a map file. Reading the text gives an equal map, except for `file`, `sha256` and the
/// goal's place.
std::string write_map(const Map& map);

}  // namespace robosim::map
