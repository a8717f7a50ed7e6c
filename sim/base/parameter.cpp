#include "sim/base/parameter.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace robosim {
namespace {

// Reads a spread: a share of the value ("5 %"), or an amount in the value's unit.
double as_spread(const ConfigValue& value, const char* key, Dimension dimension, double of) {
  if (value.kind == ConfigValue::Kind::string && value.string.find('%') != std::string::npos)
    return std::abs(of) * as_quantity(value, key, Dimension::ratio, 0.0, 10.0);
  return as_quantity(value, key, dimension, 0.0, 1e12);
}

}  // namespace

Parameter as_parameter(const ConfigValue& value, const char* key, Dimension dimension, double least,
                       double most) {
  if (value.kind != ConfigValue::Kind::table) return {as_quantity(value, key, dimension, least, most), 0.0};
  TableReader reader(value, key);
  Parameter number;
  if (const ConfigValue* newer = reader.find("typical@2")) {
    const Parameter now = as_parameter(*newer, key, dimension, least, most);
    if (now.typical_2)
      throw InputError(newer->place,
                       fmt::format("{}: \"typical@2\" cannot contain another \"typical@2\"", key));
    number.typical_2 = Spread{now.value, now.spread};
  }
  number.value = as_quantity(reader.require("value"), key, dimension, least, most);
  if (const ConfigValue* spread = reader.find("spread")) {
    number.spread = as_spread(*spread, fmt::format("the spread of {}", key).c_str(), dimension, number.value);
    const double from = number.value - number.spread, to = number.value + number.spread;
    if (from < least || to > most) {
      const WrittenUnit unit = unit_of(reader.require("value"), dimension);
      throw InputError(
          spread->place,
          fmt::format("the spread of {}: expected values from {:g} to {:g}{}{}, got {:g} to {:g}", key,
                      least / unit.si, most / unit.si, unit.name.empty() ? "" : " ", unit.name,
                      from / unit.si, to / unit.si));
    }
  }
  reader.finish();
  return number;
}

Parameter read_parameter(TableReader& reader, const char* key, Dimension dimension, Parameter fallback,
                         double least, double most) {
  const ConfigValue* value = reader.find(key);
  return value ? as_parameter(*value, key, dimension, least, most) : fallback;
}

}  // namespace robosim
