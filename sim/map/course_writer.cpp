#include "sim/map/course_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "sim/base/deterministic_trig.h"
#include "sim/base/units.h"

namespace robosim::map {
namespace {

std::string angle_text(double rad) {
  const std::string degrees = fmt::format("{} deg", std::round(rad * 180.0 / std::numbers::pi * 1e9) / 1e9);
  // The rounding to a billionth of a degree moves a point at a radius of 60 m by at most 1e-9 m.
  const auto read = parse_quantity(degrees, Dimension::angle);
  return std::fabs(*read - rad) < 2e-11 ? degrees : fmt::format("{} rad", rad);
}

std::string colour_text(const Colour& colour) {
  return fmt::format("\"{}{}\"", colour.figures().name,
                     colour.hue == Hue::grey ? fmt::format(" {} %", 100.0 * colour.black) : "");
}

// Returns the keys of a paint that differ from `usual`, each preceded by `between`.
std::string paint_text(const Course& course, int number, const Paint& usual, const char* between) {
  if (number == 0) return "";
  const Paint& paint = course.paints[static_cast<std::size_t>(number) - 1];
  std::string text;
  if (paint.width != usual.width) text += fmt::format("{}width = \"{}\"", between, length_text(paint.width));
  if (paint.colour) text += fmt::format("{}colour = {}", between, colour_text(*paint.colour));
  if (paint.worn != usual.worn) text += fmt::format("{}worn = {}", between, paint.worn);
  if (paint.gloss != usual.gloss) text += fmt::format("{}gloss = {}", between, paint.gloss);
  return text;
}

std::string segment_text(const PathPiece& piece, const std::string& paint) {
  const std::string more = piece.is_gap ? ", gap = true" : paint;
  if (piece.turn == 0.0) return fmt::format("{{ length = \"{}\"{} }}", length_text(piece.length), more);
  if (piece.length == 0.0) return fmt::format("{{ angle = \"{}\" }}", angle_text(piece.turn));
  return fmt::format("{{ radius = \"{}\", angle = \"{}\"{} }}", length_text(piece.radius),
                     angle_text(piece.turn), more);
}

std::string race_text(const RaceLines& race) {
  std::string text = "[race]\n";
  if (race.path > 0) text += fmt::format("path = {}\n", race.path + 1);
  text += fmt::format("start = \"{}\"\ngoal = \"{}\"\n", length_text(race.start), length_text(race.goal));
  if (race.braking > 0.0) text += fmt::format("braking = \"{}\"\n", length_text(race.braking));
  if (race.signal > 0.0) text += fmt::format("signal = \"{} s\"\n", race.signal);
  return text;
}

std::string rescue_text(const RescueCourse& rescue) {
  std::string checkpoints;
  for (const double along : rescue.checkpoints)
    checkpoints += fmt::format("{}\"{}\"", checkpoints.empty() ? "" : ", ", length_text(along));
  std::string text =
      fmt::format("[rescue]\ntile = \"{}\"\ncheckpoints = [{}]\n", length_text(rescue.tile), checkpoints);
  if (rescue.is_entry) text += "league = \"entry\"\n";
  if (rescue.to_zone) text += "end = \"zone\"\n";
  if (const Vec2 corner = rescue.origin; corner.x != 0.0 || corner.y != 0.0)
    text += fmt::format("origin = [\"{}\", \"{}\"]\n", length_text(corner.x), length_text(corner.y));
  return text;
}

std::string area_text(const Area& area, double usual_gloss) {
  std::string text = fmt::format("[[area]]\ncolour = {}\n", colour_text(area.colour)) + shape_text(area);
  if (area.gloss != usual_gloss) text += fmt::format("gloss = {}\n", area.gloss);
  return area.over_lines ? text + "over_lines = true\n" : text;
}

}  // namespace

std::string length_text(double m) {
  const std::string mm = fmt::format("{} mm", std::round(m * 1e6) / 1e3);
  return parse_quantity(mm, Dimension::length) == m ? mm : fmt::format("{} m", m);
}

std::string shape_text(const Shape& shape) {
  const Vec2 at = shape.middle.position;
  const std::string text = fmt::format("at = [\"{}\", \"{}\"]\n", length_text(at.x), length_text(at.y));
  if (shape.radius > 0.0) return text + fmt::format("radius = \"{}\"\n", length_text(shape.radius));
  const double angle = angle_of(shape.middle.heading);
  return text +
         fmt::format("size = [\"{}\", \"{}\"]\n", length_text(2.0 * shape.half_length),
                     length_text(2.0 * shape.half_width)) +
         (angle != 0.0 ? fmt::format("angle = \"{}\"\n", angle_text(angle)) : "");
}

std::string course_text(const Course& course, const Paint& usual) {
  std::string text;
  for (const Path& path : course.paths) {
    const Pose begin = path.begin();
    text += fmt::format("[[path]]\nfrom = [\"{}\", \"{}\"]\nheading = \"{}\"\nsegments = [\n",
                        length_text(begin.position.x), length_text(begin.position.y),
                        angle_text(angle_of(begin.heading)));
    for (const PathPiece& piece : path.pieces())
      text += "  " + segment_text(piece, paint_text(course, piece.paint, usual, ", ")) + ",\n";
    text += "]\n";
  }
  if (course.race) text += race_text(*course.race);
  if (course.rescue) text += rescue_text(*course.rescue);
  for (const Mark& mark : course.marks) {
    text += "[[mark]]\n";
    if (mark.path > 0) text += fmt::format("path = {}\n", mark.path + 1);
    text += fmt::format("along = \"{}\"\nside = \"{}\"\naway = \"{}\"\nlength = \"{}\"\nwidth = \"{}\"\n",
                        length_text(mark.along), mark.away < 0.0 ? "right" : "left",
                        length_text(std::abs(mark.away)), length_text(2.0 * mark.half_length),
                        length_text(2.0 * mark.half_width));
    if (mark.paint > 0) text += paint_text(course, mark.paint, usual, "\n").substr(1) + '\n';
  }
  for (const Area& area : course.areas) text += area_text(area, usual.gloss);
  return text + relief_text(course);
}

}  // namespace robosim::map
