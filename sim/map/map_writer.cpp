#include "sim/map/map_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/map/course_writer.h"
#include "sim/map/floor_image.h"
#include "sim/map/legend.h"

namespace robosim::map {
namespace {

// Formats a TOML basic string.
std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + '"';
}

// Returns the character for lines: `.`, or `1` if the parser could suspect that `.` and `#` are swapped
// (docs/reference/maps.md).
char line_character(const Map& map) {
  const auto lines = static_cast<std::size_t>(std::count(map.cells.begin(), map.cells.end(), Cell::line));
  return lines * 2 > map.cells.size() ? '1' : '.';
}

// Rounds a length to micrometres.
double rounded(double m) { return std::round(m * 1e6) / 1e6; }

// Returns whether the map is written without rows.
bool is_bare(const Map& map) {
  return (!map.course.paths.empty() || map.image) &&
         std::all_of(map.cells.begin(), map.cells.end(), [](Cell c) { return c == Cell::floor; }) &&
         map.surface_of_cell.empty();
}

// Returns the top-level keys, then the tables; "" if all values are defaults.
std::string front_matter(const Map& map, bool mark_goal, const std::string& legend) {
  const Map defaults;
  std::string text;
  if (!map.name.empty()) text += fmt::format("name = {}\n", toml_string(map.name));
  if (map.cell_m != defaults.cell_m) text += fmt::format("cell = \"{}\"\n", length_text(map.cell_m));
  if (map.line_m != std::min(defaults.line_m, map.cell_m))
    text += fmt::format("line = \"{}\"\n", length_text(map.line_m));
  if (map.corner_m != defaults.corner_m) text += fmt::format("corner = \"{}\"\n", length_text(map.corner_m));
  if (map.raster) text += "floor = \"raster\"\n";
  if (map.image)
    text += fmt::format("floor = {}\npixel = \"{}\"\n", toml_string(map.image->name()),
                        length_text(map.image->pixel_m()));
  if (map.light_line) text += "paint = \"white on black\"\n";
  if (map.variation) text += fmt::format("variation = {}\n", *map.variation);
  if (map.worn > 0.0) text += fmt::format("worn = {}\n", map.worn);
  if (map.gloss > 0.0) text += fmt::format("gloss = {}\n", map.gloss);
  if (is_bare(map))
    text += fmt::format("size = [\"{}\", \"{}\"]\n", length_text(rounded(map.width * map.cell_m)),
                        length_text(rounded(map.height * map.cell_m)));
  if (!map.generator.empty()) text += fmt::format("generator = {}\n", toml_string(map.generator));

  std::string stations;
  std::string goal_station;
  for (const NamedStation& s : map.stations) {
    const bool is_goal = map.goal_cell && s.cell == *map.goal_cell;
    if (is_goal) goal_station = s.name;
    if (!is_goal || s.name != "goal") stations += fmt::format("{} = [{}, {}]\n", s.name, s.cell.x, s.cell.y);
  }
  if (!map.goal.empty() && (!map.goal_cell || map.goal != "station:" + goal_station))
    text += fmt::format("goal = {}\n", toml_string(map.goal));
  if (map.start && map.start->on_path)
    text += fmt::format("[start]\npath = {}\nalong = \"{}\"\n{}", map.start->on_path->path + 1,
                        length_text(map.start->on_path->along),
                        map.start->on_path->backwards ? "backwards = true\n" : "");
  else if (map.start)
    text += fmt::format("[start]\nx = {}\ny = {}\nfacing = \"{}\"\n", map.start->cell.x, map.start->cell.y,
                        letter(map.start->facing));
  if (map.goal_cell && !mark_goal)
    text += fmt::format("[goal]\nx = {}\ny = {}\n", map.goal_cell->x, map.goal_cell->y);
  if (!stations.empty()) text += "[stations]\n" + stations;
  return text + legend + course_text(map.course, usual_paint(map)) + lights_text(map.lights);
}

}  // namespace

std::string write_map(const Map& map) {
  const LegendWriter legend(map);
  const bool mark_goal = map.goal_cell && map.at(*map.goal_cell) == Cell::line &&
                         map.surface_at(map.index_of(*map.goal_cell)) == 0;
  std::string text = front_matter(map, mark_goal, legend.text());
  if (!text.empty()) text = "+++\n" + text + "+++\n";
  if (is_bare(map)) return text;
  const char symbols[] = {'_', line_character(map), '#', '_', 'x'};
  for (CellAt c; c.y < map.height; ++c.y) {
    for (c.x = 0; c.x < map.width; ++c.x) {
      const char digit = legend.digit(map.at(c), map.surface_at(map.index_of(c)));
      text += digit                              ? digit
              : mark_goal && c == *map.goal_cell ? 'G'
                                                 : symbols[static_cast<std::size_t>(map.at(c))];
    }
    text += '\n';
  }
  return text;
}

}  // namespace robosim::map
