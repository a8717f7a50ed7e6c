#include <fmt/format.h>

#include <numbers>
#include <string>

#include "sim/base/angle.h"
#include "sim/base/units.h"
#include "sim/grid/course_reader.h"
#include "sim/grid/front_tables.h"

namespace robosim::grid {
namespace {

constexpr double kLeastSide = 1e-3, kMostSide = 100.0;  // m
constexpr double kMostAway = 10.0;                      // m
constexpr std::size_t kMostAreas = 1000;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

Colour read_colour(const ConfigValue& value) {
  const std::string& text = as_string(value, "colour");
  constexpr std::string_view kGrey = "grey ";
  if (text.starts_with(kGrey)) {
    const auto black = parse_quantity(text.substr(kGrey.size()), Dimension::ratio);
    if (black && *black >= 0.0 && *black <= 1.0) return {Hue::grey, *black};
  } else {
    for (std::size_t i = 0; i < kHues.size(); ++i)
      if (text == kHues[i].name) return {static_cast<Hue>(i)};
  }
  throw InputError(value.place,
                   fmt::format("colour is \"{}\"; allowed are black, white, grey, green, silver, "
                               "red, and grey with its share of black, as in \"grey 40 %\"",
                               text));
}

Vec2 read_pair(const ConfigValue& value, const char* key, const char* example, double least, double most) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, fmt::format("{} must be two lengths, as in {}", key, example));
  return {as_quantity(value.items[0], key, Dimension::length, least, most),
          as_quantity(value.items[1], key, Dimension::length, least, most)};
}

// Where it is: `at`, or `along` a path, and beside it.
Pose read_middle(TableReader& table, const ConfigValue& item, const Course& course) {
  const ConfigValue* const at = table.find("at");
  const ConfigValue* const along = table.find("along");
  if ((at == nullptr) == (along == nullptr))
    throw InputError(item.place,
                     "an area has a middle: either at = [\"X\", \"Y\"], to the right and up from the floor's "
                     "lower left corner, or along = \"500 mm\", on a path");
  if (at) return {read_pair(*at, "at", "[\"300 mm\", \"1.2 m\"]", 0.0, Path::kMost), {1.0, 0.0}};
  const auto paths = static_cast<std::int64_t>(course.paths.size());
  if (paths == 0) throw InputError(along->place, "[[area]] has along, and there is no [[path]]");
  const Path& path = course.paths[static_cast<std::size_t>(table.integer("path", 1, 1, paths) - 1)];
  const Pose on = path.at(as_quantity(*along, "along", Dimension::length, 0.0, path.length()), false);
  const double away = table.quantity("away", Dimension::length, 0.0, 0.0, kMostAway);
  const bool left = table.choice("side", "left", {"left", "right"}) == "left";
  return {on.position + left_of(on.heading) * (left ? away : -away), on.heading};
}

}  // namespace

void read_areas(const ConfigValue& value, Course& course) {
  for (const ConfigValue& item : tables_of(value, "area")) {
    if (course.areas.size() == kMostAreas)
      throw InputError(item.place,
                       fmt::format("this is one [[area]] too many; a map has at most {}", kMostAreas));
    TableReader table(item, "[[area]]");
    Area area;
    area.place = item.place;
    area.colour = read_colour(table.require("colour"));
    area.middle = read_middle(table, item, course);
    const ConfigValue* const size = table.find("size");
    const ConfigValue* const radius = table.find("radius");
    if ((size == nullptr) == (radius == nullptr))
      throw InputError(item.place,
                       "an area is either a rectangle, size = [\"25 mm\", \"250 mm\"], or a disc, "
                       "radius = \"50 mm\"");
    if (radius) {
      area.radius = as_quantity(*radius, "radius", Dimension::length, kLeastSide, kMostSide);
      if (const ConfigValue* const angle = table.find("angle"))
        throw InputError(angle->place, "a disc has no angle");
    } else {
      const Vec2 sides = read_pair(*size, "size", "[\"25 mm\", \"250 mm\"]", kLeastSide, kMostSide);
      area.half_length = 0.5 * sides.x;
      area.half_width = 0.5 * sides.y;
      const double angle = table.quantity("angle", Dimension::angle, 0.0, -kFullTurn, kFullTurn);
      if (angle != 0.0) area.middle.heading = turned(area.middle.heading, unit_vector(angle));
    }
    area.over_lines = table.boolean("over_lines", false);
    table.finish();
    course.areas.push_back(area);
  }
}

}  // namespace robosim::grid
