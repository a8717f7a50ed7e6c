// Functions that the readers of the front matter's tables share.
#pragma once

#include <vector>

#include "sim/base/config.h"
#include "sim/base/vec.h"
#include "sim/map/paint.h"
#include "sim/map/sampled_parameters.h"

namespace robosim::map {

/// Returns the tables [[name]]. Throws InputError if `value` is a single table.
const std::vector<ConfigValue>& tables_of(const ConfigValue& value, const char* name);

/// Reads a point ["X", "Y"]. Returns its coordinates in m, to the right and up from the floor's lower left
/// corner. Throws InputError.
Vec2 read_point(const ConfigValue& value, const char* key);
/// Reads a point whose coordinates may have a spread.
Vec2 read_point(const ConfigValue& value, const char* key, const SampledParameters& figures);

/// Reads a colour, such as "green" or "grey 40 %". Throws InputError.
Colour read_colour(const ConfigValue& value);

/// Reads `worn` or `gloss`, 0..1; `usual` is the default. Throws InputError.
double read_share(TableReader& table, const char* key, double usual);

/// Reads a vector such as ["2 mm/s", "0 mm/s"], whose components must be within +-most. Throws InputError.
Vec2 read_vector(const ConfigValue& value, const char* key, Dimension dimension, double most,
                 const SampledParameters& figures);

}  // namespace robosim::map
