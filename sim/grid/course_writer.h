// Writes [[path]] and [[mark]] of the front matter. An implementation detail of write_map.
#pragma once

#include <string>

#include "sim/grid/course.h"

namespace robosim::grid {

/// Returns "250 mm", or metres if whole micrometres would round.
std::string length_text(double m);

/// Returns the tables. Lengths, angles and places are read back within 1e-12 m. `usual` is the default paint
/// of lines and marks.
std::string course_text(const Course& course, const Paint& usual);

}  // namespace robosim::grid
