#include "sim/record/floor_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/base64.h"
#include "sim/map/floor_image.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"

namespace robosim::record {
namespace {

// Rounds to a micrometre, which is finer than any drawing and needs few digits.
double millimetres(double metres) { return std::round(metres * 1e6) / 1e3; }
std::array<double, 2> millimetres(Vec2 p) { return {millimetres(p.x), millimetres(p.y)}; }

template <class Holds>
std::vector<FloorShapes::Rectangle> runs_of(const map::Map& map, Holds holds) {
  std::vector<FloorShapes::Rectangle> runs;
  const double side = map.cell_m;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const int begin = x;
      while (x < map.width && holds(map.at({x, y}))) ++x;
      if (x > begin)
        runs.push_back({millimetres(begin * side), millimetres((map.height - 1 - y) * side),
                        millimetres((x - begin) * side), millimetres(side)});
    }
  }
  return runs;
}

// Returns the corners of a rectangle or a mark.
template <class T>
std::vector<std::array<double, 2>> corners_of(const T& shape) {
  std::vector<std::array<double, 2>> corners;
  for (const Vec2 corner : {Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}, Vec2{1, -1}})
    corners.push_back(
        millimetres(shape.middle.to_world({corner.x * shape.half_length, corner.y * shape.half_width})));
  return corners;
}

// Returns a mixture of two colours, in HTML syntax.
std::string tint(const std::array<int, 3>& from, const std::array<int, 3>& to, double share) {
  const auto mixed = [&](std::size_t i) {
    return static_cast<int>(std::lround(from[i] + share * (to[i] - from[i])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

// Adds a hill as strips that get darker with height (lighter on a dark floor).
void add_hill(const map::Hill& hill, bool on_dark, std::vector<FloorShapes::Area>& areas) {
  constexpr std::array<int, 3> kLow = {0xf6, 0xf0, 0xe2}, kHigh = {0xcf, 0xb3, 0x7e};
  constexpr std::array<int, 3> kLowOnDark = {0x2c, 0x29, 0x22}, kHighOnDark = {0x7d, 0x6a, 0x45};
  constexpr std::size_t kStrips = 12;
  const std::vector<double> heights =
      hill.pivot > 0.0 ? std::vector<double>{0.0, 2.0 * hill.pivot} : hill.heights;
  const double most = std::max(*std::max_element(heights.begin(), heights.end()), 1e-6);
  const std::size_t pieces = heights.size() - 1;
  const std::size_t strips = std::max<std::size_t>(pieces, kStrips);
  map::Hill strip = hill;
  strip.half_length = hill.half_length / static_cast<double>(strips);
  for (std::size_t i = 0; i < strips; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(strips);
    const double place = share * static_cast<double>(pieces);
    const auto before = std::min(static_cast<std::size_t>(place), pieces - 1);
    const double height =
        heights[before] + (place - static_cast<double>(before)) * (heights[before + 1] - heights[before]);
    strip.middle.position = hill.middle.to_world({(2.0 * share - 1.0) * hill.half_length, 0.0});
    areas.push_back(
        {on_dark ? tint(kLowOnDark, kHighOnDark, height / most) : tint(kLow, kHigh, height / most),
         {},
         corners_of(strip),
         false});
  }
}

const char* surface_tint(const map::SurfaceFigures& surface, bool on_dark) {
  if (surface.grip < 1.0) return on_dark ? "#24343f" : "#d9e8f3";
  return on_dark ? "#372f3b" : "#e6dcea";
}

// Adds one area for each sequence of cells with the same surface in a row of the map.
void add_legend_surfaces(const map::Map& map, std::vector<FloorShapes::Area>& areas) {
  if (map.surface_of_cell.empty()) return;
  for (map::CellAt cell; cell.y < map.height; ++cell.y)
    for (cell.x = 0; cell.x < map.width;) {
      const map::CellAt begin = cell;
      const std::uint8_t which = map.surface_at(map.index_of(cell));
      while (cell.x < map.width && map.surface_at(map.index_of(cell)) == which) ++cell.x;
      if (which == 0) continue;
      const double left = begin.x * map.cell_m, right = cell.x * map.cell_m;
      const double low = (map.height - 1 - cell.y) * map.cell_m, high = low + map.cell_m;
      FloorShapes::Area& drawn = areas.emplace_back();
      drawn.colour = surface_tint(map.legend_surfaces[which - 1u], map.light_line);
      for (const Vec2 corner : {Vec2{right, high}, Vec2{left, high}, Vec2{left, low}, Vec2{right, low}})
        drawn.corners.push_back(millimetres(corner));
    }
}

FloorShapes::Area surface_of(const map::Surface& surface, bool on_dark) {
  FloorShapes::Area drawn{surface_tint(surface, on_dark), {}, {}, false};
  const auto [x, y] = millimetres(surface.middle.position);
  if (surface.radius > 0.0)
    drawn.disc = {x, y, millimetres(surface.radius)};
  else
    drawn.corners = corners_of(surface);
  return drawn;
}

FloorShapes::Area area_of(const map::Area& area) {
  FloorShapes::Area drawn{area.colour.drawn(), {}, {}, area.over_lines};
  const auto [x, y] = millimetres(area.middle.position);
  if (area.radius > 0.0)
    drawn.disc = {x, y, millimetres(area.radius)};
  else
    drawn.corners = corners_of(area);
  return drawn;
}

map::Direction direction(char letter) {
  for (const auto d :
       {map::Direction::east, map::Direction::south, map::Direction::west, map::Direction::north})
    if (map::letter(d) == letter) return d;
  return map::Direction::east;
}

}  // namespace

FloorShapes floor_shapes(const map::Map& map, const wire::Started& started) {
  FloorShapes shapes;
  shapes.width_mm = millimetres(map.width * map.cell_m);
  shapes.height_mm = millimetres(map.height * map.cell_m);
  shapes.cell_mm = millimetres(map.cell_m);
  shapes.line_mm = millimetres(map.line_m);
  const std::vector<map::Paint> paints = map::paints_of(map);
  shapes.walls = runs_of(map, [](map::Cell c) { return c == map::Cell::wall; });
  if (map.raster) {
    shapes.dark = runs_of(map, [](map::Cell c) { return map::is_line(c) && c != map::Cell::gap; });
  } else {
    const map::Stripes stripes(map, 0.0);
    for (std::size_t i = 0; i < paints.size(); ++i) {  // in the order of painting
      const map::Paint& paint = paints[i];
      for (const map::Stripe& s : stripes.all())
        if (s.paint == i)
          shapes.stripes.push_back(
              {{millimetres(s.a.x), millimetres(s.a.y), millimetres(s.b.x), millimetres(s.b.y)},
               {millimetres(s.centre.x), millimetres(s.centre.y), millimetres(s.radius)},
               s.painted && !map.image,
               paint.width == map.line_m ? 0.0 : millimetres(paint.width),
               paint.colour == paints[0].colour ? "" : paint.colour->drawn(),
               paint.worn});
    }
  }
  if (map.image)
    shapes.picture = {base64(map.image->png()), millimetres(map.image->wide_m()),
                      millimetres(map.image->high_m())};
  shapes.light_line = map.light_line;
  for (const map::Hill& hill : map.course.hills) add_hill(hill, map.light_line, shapes.areas);
  add_legend_surfaces(map, shapes.areas);
  for (const map::Surface& surface : map.course.surfaces)
    shapes.areas.push_back(surface_of(surface, map.light_line));
  for (const map::Mark& mark : map.course.marks) {
    const map::Colour colour = *paints[static_cast<std::size_t>(mark.paint)].colour;
    if (colour != *paints[0].colour) {
      shapes.areas.push_back({colour.drawn(), {}, corners_of(mark), true});
      continue;
    }
    const Vec2 half = mark.middle.heading * mark.half_length;
    const auto from = millimetres(mark.middle.position - half), to = millimetres(mark.middle.position + half);
    shapes.marks.push_back({from[0], from[1], to[0], to[1], millimetres(2.0 * mark.half_width)});
  }
  for (const map::Area& area : map::visible_areas(map.course)) shapes.areas.push_back(area_of(area));
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (map.cells[i] == map::Cell::obstacle)
      shapes.obstacles.push_back(millimetres(map.centre(map.cell_at(i))));
  for (const map::Light& light : map.lights) {
    FloorShapes::Light& drawn = shapes.lights.emplace_back();
    if (light.at) drawn.at = millimetres(*light.at);
    drawn.radius_mm = millimetres(light.radius);
    drawn.moves_mm_s = millimetres(light.moves);
  }
  const map::Start start{{started.x, started.y}, direction(started.facing)};
  if (map.contains(start.cell) && map::is_line(map.at(start.cell)))
    for (const map::CellAt junction : map::trace_network(map, start).junctions)
      shapes.junctions.push_back(millimetres(map.centre(junction)));
  return shapes;
}

}  // namespace robosim::record
