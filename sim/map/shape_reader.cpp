// Reads and checks the shapes of a map's areas, hills, surfaces and joints (shape.h).
#include "sim/map/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "sim/base/deterministic_trig.h"
#include "sim/base/units.h"
#include "sim/map/map.h"

namespace robosim::map {
namespace {

constexpr double kLeastSide = 1e-3, kMostSide = 100.0;  // m
constexpr double kMostAway = 10.0;                      // m
constexpr double kFullTurn = 2.0 * std::numbers::pi;

const char* article(std::string_view name) { return name.front() == 'a' ? "an" : "a"; }

using Numbers = std::array<Parameter, 2>;

Numbers read_pair(const ConfigValue& value, const char* key, const char* example, double least, double most) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, fmt::format("{}: expected two lengths, as in {}", key, example));
  return {as_parameter(value.items[0], key, Dimension::length, least, most),
          as_parameter(value.items[1], key, Dimension::length, least, most)};
}

// A place next to a path: `along` the path, and `away` from it on the left or right.
class Beside {
 public:
  Beside(TableReader& table, const Path& path, const ConfigValue& along)
      : path_(path),
        along_(as_parameter(along, "along", Dimension::length, 0.0, path.length())),
        away_(read_parameter(table, "away", Dimension::length, {}, 0.0, kMostAway)),
        to_left_(table.choice("side", "left", {"left", "right"}) == "left" ? 1.0 : -1.0) {}

  void place(Shape& shape, const SampledParameters& figures) const {
    shape.middle = at(figures.drawn(along_, "along"), figures.drawn(away_, "away"));
    shape.least = shape.most = shape.middle.position;
    constexpr int kLooks = 8;
    for (int i = 0; i <= kLooks; ++i) {
      const double along = std::lerp(along_.least(), along_.most(), static_cast<double>(i) / kLooks);
      for (const double away : {away_.least(), away_.most()}) {
        const Vec2 p = at(along, away).position;
        shape.least = {std::min(shape.least.x, p.x), std::min(shape.least.y, p.y)};
        shape.most = {std::max(shape.most.x, p.x), std::max(shape.most.y, p.y)};
      }
    }
  }

 private:
  Pose at(double along, double away) const {
    const Pose on = path_.at(along, false);
    return {on.position + left_of(on.heading) * (to_left_ * away), on.heading};
  }

  const Path& path_;
  const Parameter along_, away_;
  const double to_left_;
};

// Reads the middle of a shape: `at`, or `along` and the other keys of a place next to a path.
void read_middle(Shape& shape, TableReader& table, const Course& course, const char* name,
                 const SampledParameters& figures) {
  const ConfigValue* const at = table.find("at");
  const ConfigValue* const along = table.find("along");
  if ((at == nullptr) == (along == nullptr))
    throw InputError(
        table.table().place,
        fmt::format(
            "{} {} requires a middle: either at = [\"X\", \"Y\"], to the right and up from the floor's "
            "lower left corner, or along = \"500 mm\", on a path",
            article(name), name));
  if (at) {
    const Numbers pair = read_pair(*at, "at", "[\"300 mm\", \"1.2 m\"]", 0.0, Path::kMost);
    shape.middle = {figures.drawn(pair, "at"), {1.0, 0.0}};
    shape.least = {pair[0].least(), pair[1].least()};
    shape.most = {pair[0].most(), pair[1].most()};
    return;
  }
  const auto paths = static_cast<std::int64_t>(course.paths.size());
  if (paths == 0) throw InputError(along->place, fmt::format("[[{}]] with along requires a [[path]]", name));
  const Path& path = course.paths[static_cast<std::size_t>(table.integer("path", 1, 1, paths) - 1)];
  Beside(table, path, *along).place(shape, figures);
}

void check_middle(const Map& map, const Shape& shape, const char* name) {
  const double wide = map.width * map.cell_m, high = map.height * map.cell_m;
  for (const Vec2 p : {shape.least, shape.most}) {
    if (p.x >= 0.0 && p.y >= 0.0 && p.x <= wide && p.y <= high) continue;
    throw InputError(
        shape.place,
        fmt::format("the middle of this {} {} outside the floor: expected at most {:.10g} x {:.10g} "
                    "mm, got {:.0f} mm, {:.0f} mm",
                    name, shape.least == shape.most ? "is" : "may be", 1e3 * wide, 1e3 * high, 1e3 * p.x,
                    1e3 * p.y));
  }
}

}  // namespace

void check_shapes(const Map& map) {
  for (const Area& area : map.course.areas) check_middle(map, area, "area");
  for (const Hill& hill : map.course.hills) check_middle(map, hill, "hill");
  for (const Surface& surface : map.course.surfaces) check_middle(map, surface, "surface");
  for (const Joint& joint : map.course.joints) check_middle(map, joint, "joint");
}

Shape read_shape(TableReader& table, const Course& course, const char* name, const SampledParameters& figures,
                 Parameter* length) {
  Shape shape;
  shape.place = table.table().place;
  read_middle(shape, table, course, name, figures);
  const ConfigValue* const size = table.find("size");
  const ConfigValue* const radius = table.find("radius");
  if ((size == nullptr) == (radius == nullptr))
    throw InputError(
        shape.place,
        fmt::format("{} {} requires either size = [\"25 mm\", \"250 mm\"], a rectangle, or radius = "
                    "\"50 mm\", a disc",
                    article(name), name));
  if (radius) {
    shape.radius = figures.read(*radius, "radius", Dimension::length, kLeastSide, kMostSide);
    if (const ConfigValue* const angle = table.find("angle"))
      throw InputError(angle->place, "angle requires size, a rectangle; a disc has no angle");
    return shape;
  }
  const Numbers sides = read_pair(*size, "size", "[\"25 mm\", \"250 mm\"]", kLeastSide, kMostSide);
  if (length) *length = sides[0];
  const Vec2 drawn = figures.drawn(sides, "size");
  shape.half_length = 0.5 * drawn.x;
  shape.half_width = 0.5 * drawn.y;
  const double angle = figures.read(table, "angle", Dimension::angle, 0.0, -kFullTurn, kFullTurn);
  if (angle != 0.0) shape.middle.heading = turned(shape.middle.heading, unit_vector(angle));
  return shape;
}

}  // namespace robosim::map
