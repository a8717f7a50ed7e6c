// Courses in other tools' files, as maps of ours (docs/courses.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::course {

struct Imported {
  grid::Map map;
  std::vector<std::string> remarks;  ///< what the file has and the map has not, a sentence each
};

/// A map from the text of a course file, whose kind is told from what is in it:
///   robotrace_course_cad's JSON; RoboCupJunior's is refused with a sentence
///   length and curvature, a segment a line (CSV)
///   points, x and y in metres, a line each
///   mazes of micromouse, as characters or as numbers: a line through their passages
/// `name` becomes the map's. Throws InputError with file and line.
Imported import_course(std::string_view text, const std::string& file, const std::string& name);

}  // namespace robosim::course
