// [[light]] of a map: ambient light, which infra-red sensors receive in addition to their own light.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/base/vec.h"
#include "sim/map/sampled_parameters.h"

namespace robosim::map {

/// Uniform daylight, a lamp, or a patch of sun.
struct Light {
  /// The effect on a sensor that is 3 mm above the floor, at the light's brightest spot. Everything looks
  /// whiter by this share of the difference between white and black.
  double level = 0.0;
  std::optional<Vec2> at;  ///< m, point below the lamp, or middle of the patch of sun; nullopt = everywhere
  double height = 0.0;     ///< m, of a lamp above the floor; 0 = no lamp
  double radius = 0.0;     ///< m, of a patch of sun; 0 = no patch
  Vec2 moves;              ///< m/s, velocity of the patch
  double flicker = 0.0;    ///< share of the level that flickers
  double frequency = 0.0;  ///< Hz, of the flicker; twice the mains frequency
};

/// Reads all [[light]] tables. Throws InputError.
std::vector<Light> read_lights(const ConfigValue& value, Draw draw = {});

/// Returns [[light]] tables in the format that read_lights() reads. An implementation detail of write_map().
std::string lights_text(const std::vector<Light>& lights);

}  // namespace robosim::map
