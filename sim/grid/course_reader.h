// [[path]], [[mark]], [[area]] and [race] of a map's front matter.
#pragma once

#include "sim/base/config.h"
#include "sim/grid/course.h"

namespace robosim::grid {

/// Reads all [[path]] tables. `usual`: what they are painted with where they say nothing else. Throws
/// InputError.
void read_paths(const ConfigValue& value, const Paint& usual, Course& course);

/// Reads all [[mark]] tables, which are measured along paths that have been read. `line_m`: the line's width.
void read_marks(const ConfigValue& value, double line_m, const Paint& usual, Course& course);

/// Reads all [[area]] tables, of `gloss` where they say no other. Throws InputError.
void read_areas(const ConfigValue& value, double gloss, Course& course, Draw draw = {});

/// Reads [rescue]. Throws InputError.
void read_rescue(const ConfigValue& value, Course& course);

/// Reads [race]. Throws InputError, too, where its path is not closed within `line_m` and it is no drag race.
void read_race(const ConfigValue& value, double line_m, Course& course);

}  // namespace robosim::grid
