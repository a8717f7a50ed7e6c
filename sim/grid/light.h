// [[light]] of a map: ambient light, which infra-red sensors see in addition to their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/base/vec.h"
#include "sim/grid/sampled_parameters.h"

namespace robosim::grid {

/// Uniform daylight, a lamp, or a patch of sun.
struct Light {
  /// The light's effect at its brightest spot, on a sensor 3 mm above the floor: everything looks whiter by
  /// this share of white to black.
  double level = 0.0;
  std::optional<Vec2> at;  ///< m: what the lamp hangs over, where the sun's patch is; none: everywhere
  double height = 0.0;     ///< m, of a lamp above the floor; 0: no lamp
  double radius = 0.0;     ///< m, of a patch of sun; 0: none
  Vec2 moves;              ///< m/s, of the patch
  double flicker = 0.0;    ///< the share of its level that comes and goes
  double frequency = 0.0;  ///< Hz, of that: twice the mains'
};

/// Reads all [[light]] tables. Throws InputError.
std::vector<Light> read_lights(const ConfigValue& value, Draw draw = {});

/// Writes [[light]] as read_lights reads it. An implementation detail of write_map.
std::string lights_text(const std::vector<Light>& lights);

}  // namespace robosim::grid
