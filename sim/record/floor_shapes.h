// Describes the floor of a map as shapes, for drawing. The shapes are the geometry that the simulation uses
// (sim/map/stripes.h), not the map's characters. Lengths are in mm. The origin is the map's bottom-left
// corner; x points east and y points north.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/result/fields.h"
#include "sim/wire/stream.h"

namespace robosim::record {

struct FloorShapes {
  using Rectangle = std::array<double, 4>;  ///< x, y, width, height
  struct Stripe {
    std::array<double, 4> line{};  ///< from x, y to x, y
    std::array<double, 3> arc{};   ///< centre and radius of a counter-clockwise arc; radius 0 = straight
    bool painted = true;           ///< false: the stripe is part of the route, but invisible
    double width_mm = 0.0;         ///< 0 = the usual width
    std::string colour;            ///< in HTML syntax; "" = the usual colour
    double worn = 0.0;             ///< share of the paint that is gone
    /// Returns whether this stripe and `o` are drawn with the same pen.
    bool is_like(const Stripe& o) const {
      return width_mm == o.width_mm && colour == o.colour && worn == o.worn;
    }
  };
  struct Area {
    std::string colour;            ///< in HTML syntax
    std::array<double, 3> disc{};  ///< centre and radius; radius 0 = a rectangle
    std::vector<std::array<double, 2>> corners;
    bool over_lines = false;
  };
  struct Light {
    std::optional<std::array<double, 2>> at;  ///< centre of a sun patch, or spot below a lamp; none = uniform
    double radius_mm = 0.0;                   ///< radius of a patch of sun
    std::array<double, 2> moves_mm_s{};       ///< velocity of the patch
  };
  double width_mm = 0.0, height_mm = 0.0;
  double cell_mm = 0.0;
  double line_mm = 0.0;  ///< width of the painted stripes; their ends and joints are round
  /// A picture that covers the floor. The lower left corners of the picture and of the map coincide.
  struct Picture {
    std::string png;  ///< the file in base64
    double width_mm = 0.0, height_mm = 0.0;
  };
  std::optional<Picture> picture;
  bool light_line = false;  ///< the line and the marks are light, the floor dark
  std::vector<Stripe> stripes;
  std::vector<std::array<double, 5>> marks;      ///< bars: from x, y to x, y, and width; ends are straight
  std::vector<Area> areas;                       ///< in the order of painting
  std::vector<Rectangle> dark;                   ///< on a raster floor: painted cells, joined along rows
  std::vector<Rectangle> walls;                  ///< joined along rows
  std::vector<std::array<double, 2>> obstacles;  ///< centres of cells
  std::vector<Light> lights;                     ///< in the order of their numbers
  std::vector<std::array<double, 2>> junctions;  ///< reachable junctions with three or four arms
};

template <class V>
void fields(V& v, result::Same<V, FloorShapes::Stripe>& s) {
  v("line", s.line, "from x, y to x, y");
  v("arc", s.arc, "centre and radius", {.presence = result::when(s.arc[2] > 0.0)});
  v("painted", s.painted, "false: part of the route, but invisible", {.presence = result::when(!s.painted)});
  v("width", s.width_mm, "width, if it differs from `line`", {.presence = result::when(s.width_mm > 0.0)});
  v("colour", s.colour, "HTML colour, if it differs from the usual one",
    {.presence = result::when(!s.colour.empty())});
  v("worn", s.worn, "share of the paint that is gone", {.presence = result::when(s.worn > 0.0)});
}

template <class V>
void fields(V& v, result::Same<V, FloorShapes::Area>& a) {
  v("colour", a.colour, "HTML colour");
  v("disc", a.disc, "centre and radius", {.presence = result::when(a.disc[2] > 0.0)});
  v("corners", a.corners, "corners of a rectangle", {.presence = result::when(a.disc[2] == 0.0)});
  v("over_lines", a.over_lines, "painted over the lines", {.presence = result::when(a.over_lines)});
}

template <class V>
void fields(V& v, result::Same<V, FloorShapes::Picture>& p) {
  v("png", p.png, "a PNG in base64");
  v("width", p.width_mm, "width on the floor");
  v("height", p.height_mm, "height on the floor");
}

template <class V>
void fields(V& v, result::Same<V, FloorShapes::Light>& l) {
  v("at", l.at, "centre; absent: the light is uniform", {.presence = result::when(l.at.has_value())});
  v("radius", l.radius_mm, "radius of a patch of sun", {.presence = result::when(l.radius_mm > 0.0)});
  v("moves", l.moves_mm_s, "velocity of the patch, mm/s",
    {.presence = result::when(l.moves_mm_s[0] != 0.0 || l.moves_mm_s[1] != 0.0)});
}

template <class V>
void fields(V& v, result::Same<V, FloorShapes>& f) {
  v("width", f.width_mm, "width of the map");
  v("height", f.height_mm, "height of the map");
  v("cell", f.cell_mm, "side of a cell");
  v("line", f.line_mm, "width of the stripes");
  v("light_line", f.light_line, "white on black", {.presence = result::when(f.light_line)});
  v("picture", f.picture, "the painted floor, instead of the stripes",
    {.presence = result::when(f.picture.has_value())});
  v("stripes", f.stripes, "centre lines");
  v("marks", f.marks, "bars next to the line: from x, y to x, y, and width",
    {.presence = result::when(!f.marks.empty())});
  v("areas", f.areas, "painted rectangles and discs; hills and surfaces as tints",
    {.presence = result::when(!f.areas.empty())});
  v("dark", f.dark, "painted rectangles");
  v("walls", f.walls, "rectangles");
  v("obstacles", f.obstacles, "centres of the obstacles");
  v("lights", f.lights, "lights of the room", {.presence = result::when(!f.lights.empty())});
  v("junctions", f.junctions, "centres of the junctions");
}

/// Larger pictures are neither drawn nor stored.
inline constexpr std::size_t kLargestPicture_bytes = 4'000'000;

FloorShapes floor_shapes(const map::Map& map, const wire::Started& started);

}  // namespace robosim::record
