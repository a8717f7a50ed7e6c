// Parses a robot's start, and determines the default start (map.h).
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>

#include "sim/base/units.h"
#include "sim/map/front_matter.h"
#include "sim/map/map.h"

namespace robosim::map {
namespace {

// Removes a number such as "12" from the front of the text, and returns it.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take_comma(std::string_view& text) {
  if (!text.starts_with(',')) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Direction> direction_of(std::string_view text) {
  if (text.size() != 1) return std::nullopt;
  const char c = text[0] >= 'a' && text[0] <= 'z' ? static_cast<char>(text[0] - 'a' + 'A') : text[0];
  const auto found = std::string_view("ESWN").find(c);
  if (found == std::string_view::npos) return std::nullopt;
  return static_cast<Direction>(found);
}

}  // namespace

Direction default_facing(const Map& map, CellAt cell) {
  const unsigned lines = line_neighbours(map, cell);
  return lines ? static_cast<Direction>(std::countr_zero(lines)) : Direction::east;
}

Start start_on(const Map& map, const OnPath& on) {
  Pose pose = path_pose(map, on);
  const auto column = static_cast<int>(pose.position.x / map.cell_m);
  const auto row = map.height - 1 - static_cast<int>(pose.position.y / map.cell_m);
  Start start{
      {std::clamp(column, 0, map.width - 1), std::clamp(row, 0, map.height - 1)}, Direction::east, on};
  for (int d = 1; d < 4; ++d)
    if (dot(heading(static_cast<Direction>(d)), pose.heading) > dot(heading(start.facing), pose.heading))
      start.facing = static_cast<Direction>(d);
  return start;
}

Pose path_pose(const Map& map, const OnPath& on) {
  const Path& path = map.course.paths[static_cast<std::size_t>(on.path)];
  Pose pose = path.at(on.along, path.is_closed(map.line_m));
  if (on.backwards) pose.heading = pose.heading * -1.0;
  return pose;
}

void require_cells(const Map& map, const Start& start, const char* what) {
  if (start.on_path)
    throw InputError({map.file},
                     fmt::format("{} requires a line of cells, but the start is on a path; --start X,Y,DIR "
                                 "chooses a line cell, if there is one",
                                 what));
}

Start parse_start(const Map& map, std::string_view text) {
  if (!map.course.paths.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view side = text.substr(comma);
    const auto along = parse_quantity(text.substr(0, comma), Dimension::length);
    if (along && (side.empty() || side == ",back")) {
      const double most = map.course.paths.front().length();
      if (*along < 0.0 || *along > most)
        throw InputError(fmt::format("the start is not on the path: expected 0 to {:.0f} mm, got \"{}\"",
                                     1e3 * most, text));
      return start_on(map, {0, *along, !side.empty()});
    }
  }
  const InputError malformed(fmt::format(
      "invalid start: expected COLUMN,ROW or COLUMN,ROW,DIRECTION with the direction E, S, W or N, "
      "such as 13,2,E, got \"{}\"",
      text));
  std::string_view rest = text;
  const auto x = take_number(rest);
  if (!x || !take_comma(rest)) throw malformed;
  const auto y = take_number(rest);
  if (!y) throw malformed;
  std::optional<Direction> facing;
  if (!rest.empty()) {
    if (!take_comma(rest) || !(facing = direction_of(rest))) throw malformed;
  }
  const CellAt cell{*x, *y};
  require_line(map, cell, {}, fmt::format("the start \"{}\"", text));
  if (map.at(cell) == Cell::obstacle)
    throw InputError(fmt::format("the start \"{}\" is on an obstacle", text));
  return {cell, facing ? *facing : default_facing(map, cell)};
}

Start default_start(const Map& map) {
  if (map.start) return *map.start;
  if (!map.course.paths.empty()) return start_on(map, {});
  std::optional<CellAt> first;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!is_line(map.cells[i]) || map.cells[i] == Cell::obstacle) continue;
    const CellAt cell = map.cell_at(i);
    if (line_neighbours(map, cell) != 0 && is_dead_end(map, cell)) return {cell, default_facing(map, cell)};
    if (!first) first = cell;
  }
  if (!first)
    throw InputError({map.file},
                     map.image ? "the floor is a picture without a [[path]] along its line: add one, which "
                                 "gives start, goal, laps and cross-track error"
                               : "the map has no line for a robot to start on");
  return {*first, default_facing(map, *first)};
}

}  // namespace robosim::map
