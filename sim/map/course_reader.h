// Reads [[path]], [[mark]], [[area]], [race] and [rescue] of a map's front matter.
#pragma once

#include "sim/base/config.h"
#include "sim/map/course.h"

namespace robosim::map {

/// Reads all [[path]] tables. `usual` is their default paint. Throws InputError.
void read_paths(const ConfigValue& value, const Paint& usual, Course& course);

/// Reads all [[mark]] tables. The paths must have been read before. `line_m` is the default width of a mark.
void read_marks(const ConfigValue& value, double line_m, const Paint& usual, Course& course);

/// Reads all [[area]] tables; `gloss` is their default gloss. Throws InputError.
void read_areas(const ConfigValue& value, double gloss, Course& course, Draw draw = {});

/// Reads [rescue]. Throws InputError.
void read_rescue(const ConfigValue& value, Course& course);

/// Reads [race]. Throws InputError. The path's end must be within `line_m` of its beginning, except in a drag
/// race.
void read_race(const ConfigValue& value, double line_m, Course& course);

}  // namespace robosim::map
