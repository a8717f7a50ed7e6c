#include "sim/cli/files/map_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "sim/base/did_you_mean.h"
#include "sim/base/pluralize.h"
#include "sim/cli/files/course_picture.h"
#include "sim/cli/files/graph_text.h"
#include "sim/cli/files/json_lines.h"
#include "sim/cli/files/map_generate.h"
#include "sim/cli/output.h"
#include "sim/map/clearance.h"
#include "sim/map/floor_image.h"
#include "sim/map/map.h"
#include "sim/map/network.h"
#include "sim/map/path_survey.h"
#include "sim/map/stripes.h"
#include "sim/map/true_graph.h"

namespace robosim::cli {
namespace {

constexpr std::size_t kListed = 20;  // maximum number of listed stations or bends; others are counted
constexpr double kRoom_m = 0.08;     // free width next to a path: half a medium robot's width, and a margin

struct Survey {
  map::Map map;
  map::Start start;
  map::Network network;
};

Survey survey(const std::string& name, const std::string& start) {
  Survey s{map::read_map(map::find_map(name)), {}, {}};
  s.start = start.empty() ? map::default_start(s.map) : map::parse_start(s.map, start);
  s.network = map::trace_network(s.map, s.start);
  return s;
}

// Returns the texts of the first kListed items, and the number of remaining items.
template <typename Items, typename Text>
std::string list(const Items& items, Text text) {
  std::string line;
  for (std::size_t i = 0; i < std::min(items.size(), kListed); ++i) line += (i ? "; " : "") + text(items[i]);
  if (items.size() > kListed) line += fmt::format("; and {} more", items.size() - kListed);
  return line;
}

std::string at(map::CellAt cell) { return fmt::format("{},{}", cell.x, cell.y); }

double mm(double m) { return m * 1e3; }

std::string describe_goal(const Survey& s) {
  if (!s.map.goal.empty()) return s.map.goal;
  return s.network.has_laps() ? "laps:1 (the map names none, and its line is one loop)"
                              : "tour (the map names none)";
}

void check_goal(const Survey& s) {
  const std::string& goal = s.map.goal;
  if (goal.starts_with("laps:") && !s.network.has_laps())
    throw InputError(
        s.map.goal_place,
        fmt::format("goal {} requires a single loop: the line from {} is not one", goal, at(s.start.cell)));
  if (!goal.starts_with("station:")) return;
  const std::string wanted = goal.substr(goal.find(':') + 1);
  std::vector<std::string> names;
  for (const map::Station& station : s.network.stations) {
    if (station.name == wanted || std::to_string(station.id) == wanted) return;
    names.push_back(station.name);
  }
  throw InputError(s.map.goal_place,
                   names.empty() ? fmt::format("goal {}: unknown station: no station can be reached from {}",
                                               goal, at(s.start.cell))
                                 : fmt::format("goal {}: not a station that can be reached from {}: {}", goal,
                                               at(s.start.cell), expected_one_of(wanted, names)));
}

std::size_t count_line_cells(const map::Map& map) {
  return static_cast<std::size_t>(std::count_if(map.cells.begin(), map.cells.end(), map::is_line));
}

std::string line_cells(const map::Map& map) { return pluralize(count_line_cells(map), "line cell"); }

std::string start_text(const map::Start& start) {
  if (!start.on_path) return fmt::format("{},{}", at(start.cell), map::letter(start.facing));
  return fmt::format("path {}, {:.10g} mm along{}", start.on_path->path + 1, mm(start.on_path->along),
                     start.on_path->backwards ? ", backwards" : "");
}

std::string describe_path(const map::PathSurvey& path) {
  return fmt::format(
      "  path      {:.0f} mm, {}, {}, {}{}\n", mm(path.length_m),
      path.is_closed ? "closed"
                     : fmt::format("not closed (its end is {:.0f} mm from its beginning)", mm(path.gap_m)),
      path.smallest_radius_m > 0.0 ? fmt::format("smallest radius {:.10g} mm", mm(path.smallest_radius_m))
                                   : "no arcs",
      pluralize(static_cast<std::size_t>(path.crossings), "crossing"),
      path.corners ? ", " + pluralize(static_cast<std::size_t>(path.corners), "sharp corner") : "");
}

// Rounds metres for display: to a micrometre.
double shown(double m) { return std::round(m * 1e6) / 1e6; }

// Counts the cells to which the legend assigns a surface.
std::ptrdiff_t surface_cells(const map::Map& map) {
  return std::count_if(map.surface_of_cell.begin(), map.surface_of_cell.end(),
                       [](std::uint8_t surface) { return surface != 0; });
}

std::string surfaces_text(const map::Map& map) {
  const auto cells = static_cast<std::size_t>(surface_cells(map));
  const std::size_t areas = map.course.surfaces.size();
  const std::string by_legend = pluralize(cells, "cell") + " by the legend";
  if (cells == 0) return areas > 0 ? fmt::format("{}", areas) : "";
  return areas > 0 ? fmt::format("{}, and {}", areas, by_legend) : by_legend;
}

std::string survey_json(const Survey& s) {
  const auto& [map, start, network] = s;
  JsonLines lines;
  lines.add("schema", "robosim.map/1");
  lines.add("file", map.file);
  lines.add("name", map.name);
  lines.add("columns", map.width);
  lines.add("rows", map.height);
  lines.add("cell_m", map.cell_m);
  lines.add("line_m", map.line_m);
  lines.add("paint", map.light_line ? "white on black" : "black on white");
  if (map.variation) lines.add("variation", *map.variation);
  if (map.image) {
    lines.add("picture", map.image->name());
    lines.add("pixel_m", map.image->pixel_m());
  }
  lines.add("line_cells", count_line_cells(map));
  lines.add("start", start_text(start));
  lines.add("goal", map.goal.empty() ? JsonLines::Json() : JsonLines::Json(map.goal));
  lines.add("stations", network.stations.size());
  lines.add("junctions", network.junctions.size());
  JsonLines::Json paths = JsonLines::Json::array();
  for (const map::Path& path : map.course.paths) {
    const map::PathSurvey survey = map::survey_path(path, map.line_m);
    paths.push_back({{"length_m", shown(survey.length_m)},
                     {"closed", survey.is_closed},
                     {"crossings", survey.crossings},
                     {"corners", survey.corners},
                     {"smallest_radius_m", survey.smallest_radius_m > 0.0
                                               ? JsonLines::Json(shown(survey.smallest_radius_m))
                                               : JsonLines::Json()}});
  }
  lines.add_list("paths", paths);
  if (!map.course.paints.empty()) lines.add("own_paints", map.course.paints.size());
  if (map.worn > 0.0) lines.add("worn", map.worn);
  if (map.gloss > 0.0) lines.add("gloss", map.gloss);
  lines.add("marks", map.course.marks.size());
  lines.add("areas", map.course.areas.size());
  lines.add("hills", map.course.hills.size());
  lines.add("surfaces", map.course.surfaces.size());
  if (!map.course.joints.empty()) lines.add("joints", map.course.joints.size());
  if (const std::ptrdiff_t cells = surface_cells(map); cells > 0) lines.add("surface_cells", cells);
  return lines.text();
}

std::string station_text(const map::Station& station) {
  const std::string id = std::to_string(station.id);
  return (station.name == id ? id : fmt::format("{} \"{}\"", id, station.name)) + " at " + at(station.cell);
}

// Describes worn and glossy areas, and the number of unusual kinds of line.
std::string paint_text(const map::Map& map) {
  std::vector<std::string> parts;
  if (map.worn > 0.0) parts.push_back(fmt::format("{:.10g} % worn", 100.0 * map.worn));
  if (map.gloss > 0.0) parts.push_back(fmt::format("gloss {:.10g} %", 100.0 * map.gloss));
  if (!map.course.paints.empty())
    parts.push_back(pluralize(map.course.paints.size(), "more kind") + " of line");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string room_text(const map::Narrowest& narrow) {
  const std::string where = fmt::format("path {} at {}", narrow.path + 1, at(narrow.cell));
  const char* const wall = narrow.is_edge ? "the map's edge" : "a wall";
  if (narrow.clearance_m <= 0.0)
    return fmt::format("{} runs into {}: is it meant as an obstacle?", where, wall);
  return fmt::format("{} is {:.0f} mm from {}: a robot that reaches farther to the side hits it", where,
                     mm(narrow.clearance_m), wall);
}

void describe(const Survey& s, std::ostream& out) {
  const auto& [map, start, network] = s;
  const std::string corners =
      map.corner_m > 0.0 ? fmt::format("bends of {:.10g} mm", mm(map.corner_m)) : "square bends";
  const auto narrow = map::narrowest(map, kRoom_m);
  out << fmt::format("{}: {}\n", map.file,
                     narrow ? "the map can be read, but see the note at the end" : "the map is fine");
  out << fmt::format("  size      {} x {} cells of {:.10g} mm: {:.10g} x {:.10g} mm\n", map.width, map.height,
                     mm(map.cell_m), mm(map.cell_m) * map.width, mm(map.cell_m) * map.height);
  const bool paths_only = !map.course.paths.empty() && count_line_cells(map) == 0;
  out << fmt::format("  line      {}, {:.10g} mm wide{}{}{}\n",
                     paths_only ? pluralize(map.course.paths.size(), "path") : line_cells(map),
                     mm(map.line_m), paths_only ? "" : ", " + corners,
                     map.raster ? "; floor painted in whole cells" : "",
                     map.light_line ? "; white on black" : "");
  const std::string paint = paint_text(map);
  if (!paint.empty()) out << "  paint     " << paint << '\n';
  if (map.image)
    out << fmt::format("  floor     {}, {} x {} pixels of {:.10g} mm\n", map.image->name(),
                       map.image->width(), map.image->height(), mm(map.image->pixel_m()));
  for (const map::Path& path : map.course.paths) out << describe_path(map::survey_path(path, map.line_m));
  if (!map.course.marks.empty()) out << fmt::format("  marks     {}\n", map.course.marks.size());
  if (!map.course.areas.empty()) out << fmt::format("  areas     {}\n", map.course.areas.size());
  if (!map.course.hills.empty()) out << fmt::format("  hills     {}\n", map.course.hills.size());
  if (const std::string surfaces = surfaces_text(map); !surfaces.empty())
    out << fmt::format("  surfaces  {}\n", surfaces);
  if (!map.course.joints.empty()) out << fmt::format("  joints    {}\n", map.course.joints.size());
  out << fmt::format("  start     {}\n", start_text(start));
  out << fmt::format("  goal      {}\n", describe_goal(s));
  if (!start.on_path)
    out << fmt::format("  network   {}, {}, {}\n", pluralize(network.stations.size(), "station"),
                       pluralize(network.junctions.size(), "junction"),
                       network.loop.empty() ? "not a single loop"
                                            : fmt::format("one loop of {} steps", network.loop.size()));
  if (!network.stations.empty()) out << fmt::format("  stations  {}\n", list(network.stations, station_text));
  if (!network.unreachable.empty())
    out << fmt::format("  note: {} cannot be reached from the start: {}\n",
                       pluralize(network.unreachable.size(), "station"), list(network.unreachable, at));
  const std::vector<map::TightBend> tight = map::tight_bends(map);
  if (!tight.empty())
    out << fmt::format("  note: {} legs too short for a radius of {:.10g} mm: {}\n",
                       tight.size() == 1 ? "1 bend has" : fmt::format("{} bends have", tight.size()),
                       mm(map.corner_m), list(tight, [](const map::TightBend& bend) {
                         return fmt::format("{} gets {:.10g} mm", at(bend.cell), mm(bend.radius_m));
                       }));
  if (narrow) out << "  note: " << room_text(*narrow) << '\n';
}

// Returns the terminal's size, minus one line for the prompt. Without a terminal, returns a generous size.
map::PictureOptions screen() {
  map::PictureOptions options;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
    options.columns = size.ws_col;
    options.rows = size.ws_row - 1;
  }
  return options;
}

}  // namespace

ExitStatus check_maps(const std::vector<std::string>& maps, const std::string& start, std::ostream& out,
                      std::ostream& errors, bool json) {
  ExitStatus status = ExitStatus::ok;
  for (const std::string& name : maps) {
    try {
      const Survey s = survey(name, start);
      check_goal(s);
      if (json)
        out << survey_json(s);
      else
        describe(s, out);
    } catch (const InputError& error) {
      errors << "robosim: " << error.what() << '\n';
      status = ExitStatus::bad_input;
    }
  }
  return status;
}

ExitStatus show_map(const std::string& map, const std::string& start, const map::PictureOptions& options,
                    std::ostream& out) {
  const Survey s = survey(map, start);
  out << (s.map.course.empty() ? map::draw(s.map, s.network, s.start, options)
                               : draw_course(s.map, s.start, options));
  return ExitStatus::ok;
}

std::string graph_of_map(const MapArguments& arguments) {
  const map::Map map = map::read_map(map::find_map(arguments.map));
  const map::Start start =
      arguments.start.empty() ? map::default_start(map) : map::parse_start(map, arguments.start);
  const map::TrueGraph graph = map::true_graph(map, start);
  if (arguments.json) return graph_json(start, graph);
  return arguments.dot ? graph_dot(map, graph) : graph_text(map, start, graph);
}

int map_command(const MapArguments& arguments) {
  if (arguments.action == "graph") {
    print(graph_of_map(arguments));
    return static_cast<int>(ExitStatus::ok);
  }
  std::ostringstream text, problems;
  const ExitStatus status =
      arguments.action == "show"
          ? show_map(arguments.map, arguments.start, screen(), text)
          : check_maps({arguments.map}, arguments.start, text, problems, arguments.json);
  complain(problems.str());
  print(text.str());
  return static_cast<int>(status);
}

int generate_command(const GenerateArguments& arguments) {
  std::ostringstream text;
  const ExitStatus status = generate_maps(arguments, text);
  print(text.str());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
