#include "sim/grid/front_tables.h"

#include <fmt/format.h>

#include "sim/grid/path.h"

namespace robosim::grid {

const std::vector<ConfigValue>& tables_of(const ConfigValue& value, const char* name) {
  if (value.kind != ConfigValue::Kind::array)
    throw InputError(value.place, fmt::format("{0} is {1}; write [[{0}]], with two brackets", name,
                                              to_string(value.kind)));
  return value.items;
}

Vec2 read_point(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place,
                     fmt::format("{} must be [\"X\", \"Y\"], metres to the right and up from the map's lower "
                                 "left corner, such as [\"300 mm\", \"1.2 m\"]",
                                 key));
  return {as_quantity(value.items[0], key, Dimension::length, 0.0, Path::kMost),
          as_quantity(value.items[1], key, Dimension::length, 0.0, Path::kMost)};
}

Vec2 read_vector(const ConfigValue& value, const char* key, Dimension dimension, double most) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place, fmt::format("{} must be [X, Y], to the right and up, each in {}", key,
                                              unit_names(dimension)));
  return {as_quantity(value.items[0], key, dimension, -most, most),
          as_quantity(value.items[1], key, dimension, -most, most)};
}

}  // namespace robosim::grid
