#include "sim/map/front_matter.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "sim/base/config.h"
#include "sim/base/did_you_mean.h"
#include "sim/base/goal_forms.h"
#include "sim/map/course_reader.h"
#include "sim/map/floor_image.h"
#include "sim/map/front_tables.h"

namespace robosim::map {
namespace {

constexpr double kMinCell = 0.001;  // m
constexpr double kMaxCell = 10.0;
constexpr double kMaxCorner = 100.0;
constexpr double kMaxVariation = 0.3;
constexpr double kMinPixel = 1e-5;  // m
constexpr double kMaxPixel = 0.1;

CellAt read_cell(const ConfigValue& x, const ConfigValue& y) {
  return {static_cast<int>(as_integer(x, "the column", 0, kMaxSide - 1)),
          static_cast<int>(as_integer(y, "the row", 0, kMaxSide - 1))};
}

FrontMatter::PlacedStart read_start(const ConfigValue& value, const Course& course) {
  TableReader table(value, "[start]");
  FrontMatter::PlacedStart start;
  start.place = value.place;
  const ConfigValue* x = table.find("x");
  const ConfigValue* y = table.find("y");
  if (x || y) start.cell = read_cell(x ? *x : table.require("x"), y ? *y : table.require("y"));
  const std::string facing = table.choice("facing", "", {"E", "S", "W", "N"});
  if (const ConfigValue* along = table.find("along")) {
    const auto paths = static_cast<std::int64_t>(course.paths.size());
    if (paths == 0) throw InputError(along->place, "[start] with along requires a [[path]]");
    if (start.cell || !facing.empty())
      throw InputError(along->place,
                       "[start]: `along` is a place on a path: x, y and facing, which describe a cell, are "
                       "not allowed with it");
    OnPath on;
    on.path = static_cast<int>(table.integer("path", 1, 1, paths) - 1);
    on.along = as_quantity(*along, "along", Dimension::length, 0.0,
                           course.paths[static_cast<std::size_t>(on.path)].length());
    on.backwards = table.boolean("backwards", false);
    start.on_path = on;
  }
  if (!facing.empty()) start.facing = static_cast<Direction>(std::string_view("ESWN").find(facing));
  table.finish();
  return start;
}

void read_size(const ConfigValue& value, FrontMatter& front) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, "size: expected [\"WIDTH\", \"HEIGHT\"], such as [\"3.6 m\", \"1.8 m\"]");
  const double most = kMaxSide * front.settings.cell_m;
  front.size =
      Vec2{as_quantity(value.items[0], "the width", Dimension::length, front.settings.cell_m, most),
           as_quantity(value.items[1], "the height", Dimension::length, front.settings.cell_m, most)};
  front.size_place = value.place;
}

void read_floor(TableReader& table, FrontMatter& front) {
  const ConfigValue* const pixel = table.find("pixel");
  const ConfigValue* const floor = table.find("floor");
  const std::string what = floor ? as_string(*floor, "floor") : "stripes";
  const bool is_picture = what.ends_with(".png") || what.ends_with(".PNG");
  front.settings.raster = what == "raster";
  if (!is_picture && what != "stripes" && what != "raster")
    throw InputError(floor->place,
                     fmt::format("floor: expected stripes, raster or the name of a picture next to the map, "
                                 "NAME.png, got \"{}\"{}",
                                 what, did_you_mean(what, {"stripes", "raster"})));
  if (!is_picture) {
    if (pixel) throw InputError(pixel->place, "pixel requires a picture: floor = \"NAME.png\"");
    return;
  }
  if (what.find_first_of("/\\") != what.npos || what.front() == '.')
    throw InputError(floor->place,
                     fmt::format("floor: expected the name of a picture next to the map, without "
                                 "folders, got \"{}\"",
                                 what));
  if (!pixel)
    throw InputError(floor->place, "a picture requires the side of a pixel, as in pixel = \"0.5 mm\"");
  front.picture = what;
  front.picture_place = floor->place;
  front.pixel_m = as_quantity(*pixel, "pixel", Dimension::length, kMinPixel, kMaxPixel);
}

bool is_count(std::string_view digits, int most) {
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  return error == std::errc() && end == digits.data() + digits.size() && n >= 1 && n <= most;
}

bool is_goal(std::string_view goal) {
  for (const char* word :
       {"tour", "robotrace", "ukmars", "drag-race", "rescue-line", "line-maze", "still", "none"})
    if (goal == word) return true;
  constexpr std::string_view laps = "laps:", station = "station:", maze = "line-maze:";
  if (goal.starts_with(station)) return goal.size() > station.size();
  if (goal.starts_with(maze)) return is_count(goal.substr(maze.size()), kMostMazeTries);
  return goal.starts_with(laps) && is_count(goal.substr(laps.size()), std::numeric_limits<int>::max());
}

void read_goal(const ConfigValue& value, FrontMatter& front) {
  if (value.kind == ConfigValue::Kind::table) {
    TableReader table(value, "[goal]");
    const ConfigValue& x = table.require("x");
    front.goal_cell = FrontMatter::PlacedCell{read_cell(x, table.require("y")), value.place};
    table.finish();
    return;
  }
  front.settings.goal = as_string(value, "goal");
  front.settings.goal_place = value.place;
  if (!is_goal(front.settings.goal))
    throw InputError(value.place, fmt::format("goal: {}", expected_goal(front.settings.goal)));
}

bool is_station_name(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
}

void read_stations(const ConfigValue& value, FrontMatter& front) {
  if (value.kind != ConfigValue::Kind::table)
    throw InputError(value.place,
                     fmt::format("stations: expected a table, [stations] and then lines such as dock = [13, "
                                 "2], got {}",
                                 to_string(value.kind)));
  for (const auto& [name, cell] : value.members) {
    if (!is_station_name(name))
      throw InputError(cell.place,
                       fmt::format("invalid station name: expected a letter, then letters, digits, - and _, "
                                   "got \"{}\"",
                                   name));
    if (cell.kind != ConfigValue::Kind::array || cell.items.size() != 2)
      throw InputError(cell.place, fmt::format("station {}: expected [column, row], such as [13, 2]", name));
    front.stations.push_back({{name, read_cell(cell.items[0], cell.items[1])}, cell.place});
  }
}

}  // namespace

FrontMatter read_front_matter(std::string_view text, const std::string& file, int first_line, Draw draw) {
  const ConfigValue root = parse_toml(text, file, first_line);
  TableReader table(root, "the front matter");
  FrontMatter front;
  Map& map = front.settings;
  map.name = table.string("name", "");
  map.cell_m = table.quantity("cell", Dimension::length, map.cell_m, kMinCell, kMaxCell);
  map.line_m =
      table.quantity("line", Dimension::length, std::min(map.line_m, map.cell_m), kMinCell, kMaxCell);
  if (map.line_m > map.cell_m)
    throw InputError(table.require("line").place,
                     fmt::format("line: expected at most the width of a cell, {:.10g} mm, got {:.10g} mm",
                                 map.cell_m * 1e3, map.line_m * 1e3));
  map.corner_m = table.quantity("corner", Dimension::length, map.corner_m, 0.0, kMaxCorner);
  read_floor(table, front);
  map.generator = table.string("generator", "");
  if (const ConfigValue* goal = table.find("goal")) read_goal(*goal, front);
  map.light_line =
      table.choice("paint", "black on white", {"black on white", "white on black"}) == "white on black";
  if (const ConfigValue* variation = table.find("variation"))
    map.variation = as_quantity(*variation, "variation", Dimension::ratio, 0.0, kMaxVariation);
  map.worn = read_share(table, "worn", 0.0);
  map.gloss = read_share(table, "gloss", 0.0);
  if (map.raster && map.worn > 0.0)
    throw InputError(table.require("worn").place,
                     "worn requires lines; floor = \"raster\" has painted cells");
  const Paint usual = usual_paint(map);
  if (const ConfigValue* size = table.find("size")) read_size(*size, front);
  if (const ConfigValue* paths = table.find("path")) read_paths(*paths, usual, map.course);
  if (const ConfigValue* marks = table.find("mark")) read_marks(*marks, map.line_m, usual, map.course);
  if (const ConfigValue* lights = table.find("light")) map.lights = read_lights(*lights, draw);
  if (const ConfigValue* areas = table.find("area")) read_areas(*areas, map.gloss, map.course, draw);
  if (const ConfigValue* hills = table.find("hill")) read_hills(*hills, map.course, draw);
  if (const ConfigValue* surfaces = table.find("surface")) read_surfaces(*surfaces, map.course, draw);
  if (const ConfigValue* joints = table.find("joint")) read_joints(*joints, map.course, draw);
  if (const ConfigValue* race = table.find("race")) read_race(*race, map.line_m, map.course);
  if (const ConfigValue* rescue = table.find("rescue")) read_rescue(*rescue, map.course);
  if (const ConfigValue* start = table.find("start")) front.start = read_start(*start, map.course);
  if (const ConfigValue* stations = table.find("stations")) read_stations(*stations, front);
  if (const ConfigValue* legend = table.find("legend")) front.legend = read_legend(*legend, draw);
  table.finish();
  return front;
}

void check_picture(const Map& map, const Place& place) {
  const double wide = map.image->wide_m(), high = map.image->high_m();
  const auto size = [](double x, double y) { return fmt::format("{:.10g} x {:.10g} mm", 1e3 * x, 1e3 * y); };
  if (std::min(wide, high) < map.line_m)
    throw InputError(place, fmt::format("the picture is too small: expected at least the width of the line, "
                                        "{:.10g} mm, got {}; is pixel = \"{:.10g} mm\" right?",
                                        1e3 * map.line_m, size(wide, high), 1e3 * map.image->pixel_m()));
  if (wide > map.width * map.cell_m + 1e-9 || high > map.height * map.cell_m + 1e-9)
    throw InputError(place,
                     fmt::format("the picture is larger than the floor: expected at most {}, got {}",
                                 size(map.width * map.cell_m, map.height * map.cell_m), size(wide, high)));
  if (!map.course.marks.empty())
    throw InputError(place, "[[mark]] paints, but on this floor everything painted is in the picture");
  if (map.worn > 0.0 || !map.course.paints.empty())
    throw InputError(place,
                     "lines cannot have a width, colour, worn or gloss, because everything painted on this "
                     "floor is in the picture; the whole floor may have a gloss");
}

void require_line(const Map& map, CellAt cell, const Place& place, const std::string& what) {
  if (!map.contains(cell))
    throw InputError(
        place, fmt::format("{} is outside the map: expected columns 0 to {} and rows 0 to {}, got column "
                           "{}, row {}",
                           what, map.width - 1, map.height - 1, cell.x, cell.y));
  if (!is_line(map.at(cell)))
    throw InputError(place, fmt::format("{} at column {}, row {} is not on a line: that cell is {}", what,
                                        cell.x, cell.y, cell_word(map.at(cell))));
}

}  // namespace robosim::map
