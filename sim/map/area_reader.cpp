// Reads the [[area]] tables of a map (course_reader.h), and lists the areas that sensors see (course.h).
#include <fmt/format.h>

#include <string>

#include "sim/map/course_reader.h"
#include "sim/map/front_tables.h"

namespace robosim::map {
namespace {

constexpr std::size_t kMostAreas = 1000;

}  // namespace

std::vector<Area> visible_areas(const Course& course) {
  std::vector<Area> areas = course.areas;
  for (const Joint& joint : course.joints) {
    Area& gap = areas.emplace_back();
    static_cast<Shape&>(gap) = joint;
    gap.colour = {Hue::black};
    gap.over_lines = true;
  }
  return areas;
}

void read_areas(const ConfigValue& value, double gloss, Course& course, Draw draw) {
  for (const ConfigValue& item : tables_of(value, "area")) {
    if (course.areas.size() == kMostAreas)
      throw InputError(item.place, fmt::format("too many [[area]]: expected at most {}", kMostAreas));
    TableReader table(item, "[[area]]");
    const SampledParameters figures(draw, fmt::format("[[area]] {}", course.areas.size() + 1));
    Area area;
    area.colour = read_colour(table.require("colour"));
    static_cast<Shape&>(area) = read_shape(table, course, "area", figures);
    area.over_lines = table.boolean("over_lines", false);
    area.gloss = read_share(table, "gloss", gloss);
    table.finish();
    course.areas.push_back(area);
  }
}

}  // namespace robosim::map
