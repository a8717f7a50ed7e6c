#include "sim/map/relief.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "sim/base/deterministic_trig.h"
#include "sim/map/course.h"
#include "sim/map/course_writer.h"
#include "sim/map/front_tables.h"

namespace robosim::map {
namespace {

constexpr std::size_t kMostHills = 64, kMostSurfaces = 256, kMostJoints = 128, kMostHeights = 33;
constexpr double kMostHeight = 0.5;                     // m
constexpr double kSteepest = 0.75;                      // sine of the slope angle: 48.6 degrees
constexpr double kMostSlope = 0.25 * std::numbers::pi;  // 45°
constexpr double kMostTilt = 0.5;                       // sine of a seesaw's angle: 30 degrees
constexpr double kLightest = 0.05, kHeaviest = 5.0;     // kg
constexpr double kUsualPlank = 0.6;

// Reads the heights of a hill; `shortest` is the minimum of the hill's length in m.
std::vector<double> read_heights(const ConfigValue& value, double shortest,
                                 const SampledParameters& figures) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() < 2 || value.items.size() > kMostHeights)
    throw InputError(
        value.place,
        fmt::format("heights: expected 2 to {} heights, at even distances from the hill's beginning to its "
                    "end, such as [\"0 mm\", \"60 mm\", \"60 mm\", \"0 mm\"]",
                    kMostHeights));
  std::vector<Parameter> heights;
  for (const ConfigValue& item : value.items)
    heights.push_back(as_parameter(item, "a height", Dimension::length, 0.0, kMostHeight));
  const double step = shortest / static_cast<double>(heights.size() - 1);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const bool up = heights[i].value > heights[i - 1].value;
    const double from = up ? heights[i - 1].least() : heights[i - 1].most();
    const double to = up ? heights[i].most() : heights[i].least();
    if (std::fabs(to - from) <= kSteepest * step) continue;
    throw InputError(
        value.items[i].place,
        fmt::format("the hill is too steep: expected at most {:.0f} % of height along the slope, got {:.10g} "
                    "to {:.10g} mm within {:.10g} mm; for a step, let the hill begin or end high",
                    100.0 * kSteepest, 1e3 * from, 1e3 * to, 1e3 * step));
  }
  std::vector<double> drawn;
  for (std::size_t i = 0; i < heights.size(); ++i)
    drawn.push_back(figures.drawn(heights[i], fmt::format("height {}", i)));
  return drawn;
}

Hill read_hill(const ConfigValue& item, const Course& course, const SampledParameters& figures) {
  TableReader table(item, "[[hill]]");
  Hill hill;
  Parameter length;
  static_cast<Shape&>(hill) = read_shape(table, course, "hill", figures, &length);
  if (hill.radius > 0.0)
    throw InputError(
        table.require("radius").place,
        "invalid hill: expected a rectangle, size = [\"600 mm\", \"300 mm\"], its length and width");
  const ConfigValue* const heights = table.find("heights");
  const ConfigValue* const slope = table.find("slope");
  const ConfigValue* const seesaw = table.find("seesaw");
  const ConfigValue* const plank = table.find("plank");
  if ((heights != nullptr) + (slope != nullptr) + (seesaw != nullptr) != 1) {
    table.refuse_misspelt();
    throw InputError(item.place,
                     "invalid hill: expected one of heights = [\"0 mm\", \"60 mm\"], slope = \"20 deg\" for "
                     "an even ramp, or "
                     "seesaw = \"50 mm\", the height of its axis");
  }
  if (plank && !seesaw) throw InputError(plank->place, "plank, the mass of a seesaw, requires seesaw");
  if (heights) hill.heights = read_heights(*heights, length.least(), figures);
  if (slope) {
    const Parameter angle = as_parameter(*slope, "slope", Dimension::angle, -kMostSlope, kMostSlope);
    const double steepest = std::max(angle.most(), -angle.least());
    if (const double most = length.most() * unit_vector(steepest).y; most > kMostHeight)
      throw InputError(
          slope->place,
          fmt::format("the ramp is too high: expected at most {:.4g} m, got {:.4g} m", kMostHeight, most));
    const double rise = 2.0 * hill.half_length * unit_vector(figures.drawn(angle, "slope")).y;
    hill.heights = {std::fmax(-rise, 0.0), std::fmax(rise, 0.0)};
  }
  if (seesaw) {
    const Parameter pivot = as_parameter(*seesaw, "seesaw", Dimension::length, 1e-3, kMostHeight);
    if (pivot.most() > 0.5 * kMostTilt * length.least())
      throw InputError(
          seesaw->place,
          fmt::format(
              "the seesaw is too steep: expected at most 30 deg, got more with a length of {:.10g} mm "
              "and an axis at {:.10g} mm",
              1e3 * length.least(), 1e3 * pivot.most()));
    hill.pivot = figures.drawn(pivot, "seesaw");
    hill.plank_kg =
        plank ? figures.read(*plank, "plank", Dimension::mass, kLightest, kHeaviest) : kUsualPlank;
  }
  table.finish();
  return hill;
}

Surface read_surface(const ConfigValue& item, const Course& course, const SampledParameters& figures) {
  TableReader table(item, "[[surface]]");
  Surface surface;
  static_cast<Shape&>(surface) = read_shape(table, course, "surface", figures);
  static_cast<SurfaceFigures&>(surface) = read_surface_figures(table, figures);
  table.finish();
  return surface;
}

}  // namespace

std::string surface_names() {
  std::string names;
  for (const SurfaceKind& one : kSurfaces) {
    const bool is_last = &one + 1 == std::end(kSurfaces);
    names += fmt::format("{}{}", names.empty() ? "" : is_last ? " or " : ", ", one.name);
  }
  return names;
}

SurfaceFigures read_surface_figures(TableReader& table, const SampledParameters& figures) {
  SurfaceFigures surface;
  const ConfigValue* const kind = table.find("kind");
  const ConfigValue* const grip = table.find("grip");
  const ConfigValue* const rolling = table.find("rolling");
  if ((kind != nullptr) == (grip || rolling)) {
    table.refuse_misspelt();
    throw InputError(table.table().place,
                     "invalid surface: expected either a kind, as in kind = \"carpet\", or values: grip = "
                     "0.5, a factor for the robot's grip, and rolling = 0.03, added to the robot's rolling");
  }
  if (kind) {
    std::vector<std::string> names;
    for (const SurfaceKind& one : kSurfaces) names.emplace_back(one.name);
    const std::string name = table.choice("kind", "", names);
    for (const SurfaceKind& one : kSurfaces)
      if (name == one.name) surface.grip = one.grip, surface.rolling = one.rolling;
  }
  if (grip) surface.grip = figures.read(*grip, "grip", Dimension::ratio, 0.05, 2.0);
  if (rolling) surface.rolling = figures.read(*rolling, "rolling", Dimension::ratio, 0.0, 0.5);
  return surface;
}

double Hill::height_at(Vec2 p) const {
  if (heights.empty()) return 0.0;
  const double at = (middle.to_body(p).x / half_length + 1.0) * 0.5 * static_cast<double>(heights.size() - 1);
  const auto before = static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(heights.size() - 2)));
  return std::lerp(heights[before], heights[before + 1], at - static_cast<double>(before));
}

void read_hills(const ConfigValue& value, Course& course, Draw draw) {
  for (const ConfigValue& item : tables_of(value, "hill")) {
    if (course.hills.size() == kMostHills)
      throw InputError(item.place, fmt::format("too many [[hill]]: expected at most {}", kMostHills));
    const SampledParameters figures(draw, fmt::format("[[hill]] {}", course.hills.size() + 1));
    course.hills.push_back(read_hill(item, course, figures));
  }
}

void read_surfaces(const ConfigValue& value, Course& course, Draw draw) {
  for (const ConfigValue& item : tables_of(value, "surface")) {
    if (course.surfaces.size() == kMostSurfaces)
      throw InputError(item.place, fmt::format("too many [[surface]]: expected at most {}", kMostSurfaces));
    const SampledParameters figures(draw, fmt::format("[[surface]] {}", course.surfaces.size() + 1));
    course.surfaces.push_back(read_surface(item, course, figures));
  }
}

void read_joints(const ConfigValue& value, Course& course, Draw draw) {
  for (const ConfigValue& item : tables_of(value, "joint")) {
    if (course.joints.size() == kMostJoints)
      throw InputError(item.place, fmt::format("too many [[joint]]: expected at most {}", kMostJoints));
    TableReader table(item, "[[joint]]");
    Parameter gap;
    Joint joint;
    static_cast<Shape&>(joint) =
        read_shape(table, course, "joint",
                   SampledParameters(draw, fmt::format("[[joint]] {}", course.joints.size() + 1)), &gap);
    if (joint.radius > 0.0)
      throw InputError(table.require("radius").place,
                       "invalid joint: expected a gap between boards, size = [\"3 mm\", \"300 mm\"], its "
                       "width and length");
    if (gap.most() > Joint::kWidest)
      throw InputError(
          table.require("size").items[0].place,
          fmt::format("the joint is too wide: expected at most {:.10g} mm, got {:.10g} mm; size is its width "
                      "and length, as in [\"3 mm\", \"300 mm\"]",
                      1e3 * Joint::kWidest, 1e3 * gap.most()));
    table.finish();
    course.joints.push_back(joint);
  }
}

std::string relief_text(const Course& course) {
  std::string text;
  for (const Hill& hill : course.hills) {
    text += "[[hill]]\n" + shape_text(hill);
    if (hill.pivot > 0.0) {
      text += fmt::format("seesaw = \"{}\"\nplank = \"{} kg\"\n", length_text(hill.pivot), hill.plank_kg);
      continue;
    }
    std::string list;
    for (const double height : hill.heights)
      list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", length_text(height));
    text += fmt::format("heights = [{}]\n", list);
  }
  for (const Surface& surface : course.surfaces)
    text += fmt::format("[[surface]]\n{}grip = {}\nrolling = {}\n", shape_text(surface), surface.grip,
                        surface.rolling);
  for (const Joint& joint : course.joints) text += "[[joint]]\n" + shape_text(joint);
  return text;
}

}  // namespace robosim::map
