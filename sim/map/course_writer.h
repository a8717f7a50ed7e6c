// Writes a course's tables of the front matter. An implementation detail of write_map().
#pragma once

#include <string>

#include "sim/map/course.h"

namespace robosim::map {

/// Returns a length such as "250 mm". Uses metres if rounding to whole micrometres would change the length.
std::string length_text(double m);

/// Returns the course's tables. Reading them back reproduces lengths exactly, and angles within 2e-11 rad.
/// `usual` is the default paint of lines and marks.
std::string course_text(const Course& course, const Paint& usual);

}  // namespace robosim::map
