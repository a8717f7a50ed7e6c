// [[path]] and [[mark]] as the front matter has them. An implementation detail of write_map.
#pragma once

#include <string>

#include "sim/grid/course.h"

namespace robosim::grid {

/// "250 mm", or in m where whole micrometres would round.
std::string length_text(double m);

/// Lengths, angles and places are read back within 1e-12 m.
/// `usual`: what lines and marks are painted with where nothing else is said.
std::string course_text(const Course& course, const Paint& usual);

}  // namespace robosim::grid
