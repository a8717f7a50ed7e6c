#include "sim/map/light.h"

#include <fmt/format.h>

#include "sim/map/course_writer.h"
#include "sim/map/front_tables.h"

namespace robosim::map {
namespace {

constexpr double kMostLevel = 10.0;
constexpr double kLeastHeight = 0.01, kMostHeight = 100.0;  // m
constexpr double kMostPatch = 100.0;                        // m
constexpr double kMostSpeed = 1.0;                          // m/s
constexpr double kMains = 100.0;                            // Hz: twice 50 Hz
constexpr double kLeastFrequency = 0.01, kMostFrequency = 100e3;
constexpr std::size_t kMostLights = 64;

Light read_light(const ConfigValue& value, const SampledParameters& figures) {
  TableReader table(value, "[[light]]");
  Light light;
  light.level = figures.read(table.require("level"), "level", Dimension::ratio, 0.0, kMostLevel);
  if (const ConfigValue* at = table.find("at")) light.at = read_point(*at, "at", figures);
  const ConfigValue* const height = table.find("height");
  const ConfigValue* const radius = table.find("radius");
  const ConfigValue* const moves = table.find("moves");
  if (height) light.height = figures.read(*height, "height", Dimension::length, kLeastHeight, kMostHeight);
  if (radius) light.radius = figures.read(*radius, "radius", Dimension::length, 1e-3, kMostPatch);
  if (moves) light.moves = read_vector(*moves, "moves", Dimension::speed, kMostSpeed, figures);
  if (const ConfigValue* flicker = table.find("flicker"))
    light.flicker = figures.read(*flicker, "flicker", Dimension::ratio, 0.0, 1.0);
  light.frequency =
      figures.read(table, "frequency", Dimension::frequency, kMains, kLeastFrequency, kMostFrequency);
  table.finish();
  const bool is_one = light.at ? (height != nullptr) != (radius != nullptr) : !height && !radius;
  if (!is_one || (moves && !radius))
    throw InputError(value.place,
                     "invalid light: expected a lamp, which has `at` and `height`; a patch of sun, which has "
                     "`at`, `radius` and, if it moves, `moves`; or none of these keys, for daylight that is "
                     "the same everywhere");
  return light;
}

}  // namespace

std::vector<Light> read_lights(const ConfigValue& value, Draw draw) {
  std::vector<Light> lights;
  for (const ConfigValue& item : tables_of(value, "light")) {
    if (lights.size() == kMostLights)
      throw InputError(item.place, fmt::format("too many lights: expected at most {}", kMostLights));
    lights.push_back(
        read_light(item, SampledParameters(draw, fmt::format("[[light]] {}", lights.size() + 1))));
  }
  return lights;
}

std::string lights_text(const std::vector<Light>& lights) {
  std::string text;
  for (const Light& light : lights) {
    text += fmt::format("[[light]]\nlevel = {}\n", light.level);
    if (light.at)
      text += fmt::format("at = [\"{}\", \"{}\"]\n", length_text(light.at->x), length_text(light.at->y));
    if (light.height > 0.0) text += fmt::format("height = \"{}\"\n", length_text(light.height));
    if (light.radius > 0.0) text += fmt::format("radius = \"{}\"\n", length_text(light.radius));
    if (light.moves != Vec2{})
      text += fmt::format("moves = [\"{} m/s\", \"{} m/s\"]\n", light.moves.x, light.moves.y);
    if (light.flicker > 0.0)
      text += fmt::format("flicker = {}\nfrequency = \"{} Hz\"\n", light.flicker, light.frequency);
  }
  return text;
}

}  // namespace robosim::map
