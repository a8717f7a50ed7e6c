#include "sim/map/front_tables.h"

#include <fmt/format.h>

#include "sim/base/did_you_mean.h"
#include "sim/base/units.h"
#include "sim/map/path.h"

namespace robosim::map {

const std::vector<ConfigValue>& tables_of(const ConfigValue& value, const char* name) {
  if (value.kind != ConfigValue::Kind::array)
    throw InputError(value.place, fmt::format("{0}: expected [[{0}]], with two brackets, got {1}", name,
                                              to_string(value.kind)));
  return value.items;
}

namespace {

void check_point(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(
        value.place,
        fmt::format("{}: expected [\"X\", \"Y\"], lengths to the right and up from the map's lower "
                    "left corner, such as [\"300 mm\", \"1.2 m\"]",
                    key));
}

}  // namespace

Vec2 read_point(const ConfigValue& value, const char* key) {
  check_point(value, key);
  return {as_quantity(value.items[0], key, Dimension::length, 0.0, Path::kMost),
          as_quantity(value.items[1], key, Dimension::length, 0.0, Path::kMost)};
}

Vec2 read_point(const ConfigValue& value, const char* key, const SampledParameters& figures) {
  check_point(value, key);
  return figures.read_pair(value, key, Dimension::length, 0.0, Path::kMost);
}

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
  std::vector<std::string> names;
  for (const auto& hue : kHues) names.emplace_back(hue.name);
  throw InputError(
      value.place,
      fmt::format("colour: expected black, white, grey, green, silver, red, or grey with its share "
                  "of black, as in \"grey 40 %\", got \"{}\"{}",
                  text, did_you_mean(text, names)));
}

double read_share(TableReader& table, const char* key, double usual) {
  return table.quantity(key, Dimension::ratio, usual, 0.0, 1.0);
}

Vec2 read_vector(const ConfigValue& value, const char* key, Dimension dimension, double most,
                 const SampledParameters& figures) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, fmt::format("{}: expected [X, Y], to the right and up, each in {}", key,
                                              unit_names(dimension)));
  return figures.read_pair(value, key, dimension, -most, most);
}

}  // namespace robosim::map
