#include "sim/grid/patch.h"

#include <fmt/format.h>

#include <numbers>
#include <string_view>

#include "sim/base/angle.h"
#include "sim/base/units.h"
#include "sim/grid/map.h"

namespace robosim::grid {
namespace {

constexpr double kLeastSide = 1e-3, kMostSide = 100.0;  // m
constexpr double kMostAway = 10.0;                      // m
constexpr double kFullTurn = 2.0 * std::numbers::pi;

const char* article(std::string_view name) { return name.front() == 'a' ? "an" : "a"; }

Vec2 read_pair(const ConfigValue& value, const char* key, const char* example, double least, double most) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, fmt::format("{} must be two lengths, as in {}", key, example));
  return {as_quantity(value.items[0], key, Dimension::length, least, most),
          as_quantity(value.items[1], key, Dimension::length, least, most)};
}

// Where it is: `at`, or `along` a path, and beside it.
Pose read_middle(TableReader& table, const Course& course, const char* name) {
  const ConfigValue* const at = table.find("at");
  const ConfigValue* const along = table.find("along");
  if ((at == nullptr) == (along == nullptr))
    throw InputError(
        table.table().place,
        fmt::format("{} {} has a middle: either at = [\"X\", \"Y\"], to the right and up from the floor's "
                    "lower left corner, or along = \"500 mm\", on a path",
                    article(name), name));
  if (at) return {read_pair(*at, "at", "[\"300 mm\", \"1.2 m\"]", 0.0, Path::kMost), {1.0, 0.0}};
  const auto paths = static_cast<std::int64_t>(course.paths.size());
  if (paths == 0)
    throw InputError(along->place, fmt::format("[[{}]] has along, and there is no [[path]]", name));
  const Path& path = course.paths[static_cast<std::size_t>(table.integer("path", 1, 1, paths) - 1)];
  const Pose on = path.at(as_quantity(*along, "along", Dimension::length, 0.0, path.length()), false);
  const double away = table.quantity("away", Dimension::length, 0.0, 0.0, kMostAway);
  const bool left = table.choice("side", "left", {"left", "right"}) == "left";
  return {on.position + left_of(on.heading) * (left ? away : -away), on.heading};
}

void check_middle(const Map& map, const Patch& patch, const char* name) {
  const double wide = map.width * map.cell_m, high = map.height * map.cell_m;
  const Vec2 p = patch.middle.position;
  if (p.x < 0.0 || p.y < 0.0 || p.x > wide || p.y > high)
    throw InputError(patch.place,
                     fmt::format("the middle of this {}, {:.0f} mm, {:.0f} mm, is beside the floor, which is "
                                 "{:.10g} x {:.10g} mm",
                                 name, 1e3 * p.x, 1e3 * p.y, 1e3 * wide, 1e3 * high));
}

}  // namespace

void check_patches(const Map& map) {
  for (const Area& area : map.course.areas) check_middle(map, area, "area");
  for (const Hill& hill : map.course.hills) check_middle(map, hill, "hill");
  for (const Surface& surface : map.course.surfaces) check_middle(map, surface, "surface");
}

Patch read_patch(TableReader& table, const Course& course, const char* name) {
  Patch patch;
  patch.place = table.table().place;
  patch.middle = read_middle(table, course, name);
  const ConfigValue* const size = table.find("size");
  const ConfigValue* const radius = table.find("radius");
  if ((size == nullptr) == (radius == nullptr))
    throw InputError(patch.place,
                     fmt::format("{} {} is either a rectangle, size = [\"25 mm\", \"250 mm\"], or a disc, "
                                 "radius = \"50 mm\"",
                                 article(name), name));
  if (radius) {
    patch.radius = as_quantity(*radius, "radius", Dimension::length, kLeastSide, kMostSide);
    if (const ConfigValue* const angle = table.find("angle"))
      throw InputError(angle->place, "a disc has no angle");
    return patch;
  }
  const Vec2 sides = read_pair(*size, "size", "[\"25 mm\", \"250 mm\"]", kLeastSide, kMostSide);
  patch.half_length = 0.5 * sides.x;
  patch.half_width = 0.5 * sides.y;
  const double angle = table.quantity("angle", Dimension::angle, 0.0, -kFullTurn, kFullTurn);
  if (angle != 0.0) patch.middle.heading = turned(patch.middle.heading, unit_vector(angle));
  return patch;
}

}  // namespace robosim::grid
