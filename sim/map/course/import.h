// Imports course files of other tools as maps (docs/reference/courses.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/map/map.h"

namespace robosim::course {

struct Imported {
  map::Map map;
  std::vector<std::string> remarks;  ///< features of the file that the map lacks, one sentence each
};

/// Returns a map from the text of a course file. The content determines its kind:
///   JSON of robotrace_course_cad, or of rcj-rescue-cms (RoboCupJunior Rescue Line)
///   length and curvature, one segment per line (CSV)
///   points, x and y in metres, one per line
///   mazes of micromouse, as characters or as numbers; the lines follow the maze's passages
/// `name` becomes the name of the map. `walls_m` is the distance in m between the middles of neighbouring
/// cells. If `walls_m` is above 0, a maze becomes a map with walls, whose lines are not painted. Throws
/// InputError with file and line.
Imported import_course(std::string_view text, const std::string& file, const std::string& name,
                       double walls_m = 0.0);

/// Returns a map from a PNG whose pixels have sides of `pixel_m` m. The map has no line, since pictures do
/// not define a route.
Imported import_picture(std::string png, const std::string& file, const std::string& name, double pixel_m);
/// Returns whether `bytes` are a PNG.
bool is_picture(std::string_view bytes);

}  // namespace robosim::course
