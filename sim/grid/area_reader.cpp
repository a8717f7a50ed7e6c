#include <fmt/format.h>

#include <string>

#include "sim/base/units.h"
#include "sim/grid/course_reader.h"
#include "sim/grid/front_tables.h"

namespace robosim::grid {
namespace {

constexpr std::size_t kMostAreas = 1000;

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

}  // namespace

void read_areas(const ConfigValue& value, Course& course) {
  for (const ConfigValue& item : tables_of(value, "area")) {
    if (course.areas.size() == kMostAreas)
      throw InputError(item.place,
                       fmt::format("this is one [[area]] too many; a map has at most {}", kMostAreas));
    TableReader table(item, "[[area]]");
    Area area;
    area.colour = read_colour(table.require("colour"));
    static_cast<Patch&>(area) = read_patch(table, course, "area");
    area.over_lines = table.boolean("over_lines", false);
    table.finish();
    course.areas.push_back(area);
  }
}

}  // namespace robosim::grid
