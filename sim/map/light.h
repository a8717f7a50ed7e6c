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
  /// The effect at the light's brightest spot, on a sensor 3 mm above the floor: everything looks whiter by
  /// this share of the difference between white and black.
  double level = 0.0;
  std::optional<Vec2> at;  ///< in m: point below the lamp, or middle of the sun's patch; nullopt = everywhere
  double height = 0.0;     ///< height of a lamp above the floor in m; 0 = no lamp
  double radius = 0.0;     ///< radius of a patch of sun in m; 0 = no patch
  Vec2 moves;              ///< velocity of the patch in m/s
  double flicker = 0.0;    ///< the part of `level` that flickers, as a share of it
  double frequency = 0.0;  ///< frequency of the flicker in Hz; usually twice the mains frequency
};

/// Reads all [[light]] tables. Throws InputError.
std::vector<Light> read_lights(const ConfigValue& value, Draw draw = {});

/// Returns [[light]] tables in the format that read_lights() reads. An implementation detail of write_map().
std::string lights_text(const std::vector<Light>& lights);

}  // namespace robosim::map
