// What the readers of a front matter's tables have in common.
#pragma once

#include <vector>

#include "sim/base/config.h"
#include "sim/base/vec.h"
#include "sim/grid/drawn.h"
#include "sim/grid/paint.h"

namespace robosim::grid {

/// The tables [[name]]. Throws InputError if `value` is a single one.
const std::vector<ConfigValue>& tables_of(const ConfigValue& value, const char* name);

/// ["X", "Y"], m to the right and up from the floor's lower left corner. Throws InputError.
Vec2 read_point(const ConfigValue& value, const char* key);
/// The same, where both may have a spread.
Vec2 read_point(const ConfigValue& value, const char* key, const Figures& figures);

/// One of the colours, or "grey 40 %". Throws InputError.
Colour read_colour(const ConfigValue& value);

/// What `worn` or `gloss` say, 0..1; `usual` where they say nothing. Throws InputError.
double read_share(TableReader& table, const char* key, double usual);

/// What is measured in two directions, such as ["2 mm/s", "0 mm/s"], within +-most. Throws InputError.
Vec2 read_vector(const ConfigValue& value, const char* key, Dimension dimension, double most,
                 const Figures& figures);

}  // namespace robosim::grid
