// Declares the readers of all course formats. import.h selects a reader.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/map/course/import.h"

namespace robosim::course {

/// Reads robotrace_course_cad (NTF's Robotrace): circles in driving order, joined by their tangents.
///   consecutive circles i, j with radii r, signs s (+1 = counter-clockwise, -1 = clockwise),
///   (dx, dy) from centre to centre, D = |(dx, dy)|, d = s_j r_j - s_i r_i:
///   the tangent's length L = sqrt(D^2 - d^2), its direction u = ((dx L + dy d), (dy L - dx d)) / D^2,
///   its ends centre + s r (u_y, -u_x)
/// Adds marks: left of the line at each change of curvature, and right of the line at start and goal. Start
/// and goal are 1 m apart, if they fit on the straight between the last circle and the first.
Imported read_robotrace(const nlohmann::json& json, const std::string& file);

/// Reads a RoboCupJunior Rescue Line course of rcj-rescue-cms, made of tiles of 300 mm. The first path is the
/// line from the start tile, the second path the line after the evacuation zone. The other lines of the tiles
/// follow. The remarks name the features that a map cannot represent. `json` must have the key “tiles”.
Imported read_rescue(const nlohmann::json& json, const std::string& file);

/// Parses JSON. Throws InputError with the line of the first error.
nlohmann::json json_of(std::string_view text, const std::string& file);

/// Reads "length[m], curvature[1/m]", one segment per line; a positive curvature is to the left. The course
/// begins at its start line. If the start line is straight ahead of the course's end, a straight closes the
/// lap.
Imported read_curvature(std::string_view text, const std::string& file);

/// Reads "x y" in metres. The path consists of straights and corners, and passes each point within 0.3 mm.
Imported read_points(std::string_view text, const std::string& file);

/// Reads a maze as text (mazefiles, mms). Passages become lines, and dead ends become stations. `walls_m` is
/// 0 for a maze without walls. With walls, it is the distance between the middles of neighbouring cells.
Imported read_maze(std::string_view text, const std::string& file, double walls_m);
/// Reads the other format of mms: "x y N E S W" per line, 1 = wall.
Imported read_maze_numbers(std::string_view text, const std::string& file, double walls_m);

// --- shared helpers ---

/// The width of a line, and its distance from the board's edge, in m, by Robotrace's rules 1-3 and 1-6 (NTF).
inline constexpr double kRobotraceLine = 0.019;
inline constexpr double kBoardMargin = 0.20;

/// A line without its line end. Blank lines are skipped.
struct NumberedLine {
  int number = 0;
  std::string_view text;
};
std::vector<NumberedLine> lines_of(std::string_view text);

/// Returns the numbers of a line, separated by blanks, commas or semicolons. Throws InputError for any other
/// text.
std::vector<double> numbers_in(const NumberedLine& line, const std::string& file);

/// Rounds to micrometres.
double rounded(double m);

/// Returns a map with these paths on a floor that leaves `margin` m around them. The paths are moved to fit.
/// Their numbers are rounded to micrometres and millionths of a degree, for readability.
map::Map map_around(const std::vector<map::Path>& paths, double line_m, double margin);

}  // namespace robosim::course
