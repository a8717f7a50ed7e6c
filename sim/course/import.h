// Courses in other tools' files, as maps of ours (docs/reference/courses.md).
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
///   robotrace_course_cad's JSON, and that of rcj-rescue-cms (RoboCupJunior Rescue Line)
///   length and curvature, a segment a line (CSV)
///   points, x and y in metres, a line each
///   mazes of micromouse, as characters or as numbers: a line through their passages
/// `name` becomes the map's. With `walls_m`, m from the middle of one of its cells to that of the next, a
/// maze has its walls, and its lines are not painted. Throws InputError with file and line.
Imported import_course(std::string_view text, const std::string& file, const std::string& name,
                       double walls_m = 0.0);

/// The same of a PNG, whose pixels have sides of `pixel_m` m. The map has no line: what leads where is not
/// read from pictures.
Imported import_picture(std::string png, const std::string& file, const std::string& name, double pixel_m);
/// Whether these are a PNG's bytes.
bool is_picture(std::string_view bytes);

}  // namespace robosim::course
