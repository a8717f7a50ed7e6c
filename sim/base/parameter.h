// Represents parameters that vary between robots and between runs.
#pragma once

#include <algorithm>
#include <optional>

#include "sim/base/config.h"
#include "sim/base/noise.h"
#include "sim/base/profile.h"

namespace robosim {

/// A nominal value, and the largest deviation of an individual robot from it.
struct Spread {
  double value = 0.0;   ///< SI
  double spread = 0.0;  ///< SI; each robot's own value is uniformly distributed in value ± spread
};

/// A parameter of a robot file or a map: `"625 rpm"`, or `{ value = "625 rpm", spread = "5 %" }`. A corrected
/// parameter keeps its former value for `ideal` and older profiles, whose runs must not change:
///   { value = "15 oz in", "typical@2" = "0.74 kg cm" }
struct Parameter {
  double value = 0.0;                              ///< SI
  double spread = 0.0;                             ///< SI
  std::optional<Spread> typical_2 = std::nullopt;  ///< value from the profile typical@2 on

  /// Returns the value and spread that apply in a profile.
  Spread in(Profile profile) const {
    return typical_2 && profile >= Profile::typical_2 ? *typical_2 : Spread{value, spread};
  }
  /// Return the smallest and the largest value in any profile.
  double least() const {
    return std::min(value - spread, typical_2 ? typical_2->value - typical_2->spread : value);
  }
  double most() const {
    return std::max(value + spread, typical_2 ? typical_2->value + typical_2->spread : value);
  }
  /// Returns the value that the robot with this noise stream has.
  double drawn(Profile profile, const NoiseStream& stream) const {
    const Spread now = in(profile);
    return now.spread == 0.0 ? now.value : now.value + now.spread * (2.0 * stream.uniform(0) - 1.0);
  }
  /// Returns the parameter multiplied by a factor.
  Parameter scaled(double factor) const {
    Parameter all{value * factor, spread * factor};
    if (typical_2) all.typical_2 = Spread{typical_2->value * factor, typical_2->spread * factor};
    return all;
  }
};

/// Returns `value` as a parameter whose whole range lies within the inclusive bounds. Throws InputError.
Parameter as_parameter(const ConfigValue& value, const char* key, Dimension dimension, double least,
                       double most);
Parameter read_parameter(TableReader& reader, const char* key, Dimension dimension, Parameter fallback,
                         double least, double most);

}  // namespace robosim
