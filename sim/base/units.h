// Parses quantities in the forms that people write: "150 mm", "7.4 V", "60s". Internally all values are in SI
// units.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace robosim {

/// Standard gravity, m/s2 (BIPM, SI brochure).
constexpr double kGravity = 9.80665;

enum class Dimension {
  length,         ///< m        mm cm m in
  time,           ///< s        ns us ms s min h d
  angle,          ///< rad      deg rad
  voltage,        ///< V        mV V
  current,        ///< A        mA A
  mass,           ///< kg       g kg
  inertia,        ///< kg m2    "g mm2" "kg m2" "g cm2"
  torque,         ///< N m      "mN m" "N m" "kg cm" "oz in"
  rotation_rate,  ///< rad/s    rpm rad/s deg/s
  speed,          ///< m/s      m/s mm/s cm/s
  frequency,      ///< Hz       Hz kHz MHz
  resistance,     ///< ohm      ohm kohm
  inductance,     ///< H        uH mH H
  ratio,          ///< 1        a bare number, or "%"
};

/// Returns the unit names of a dimension, for messages: "mm, cm, m or in".
std::string unit_names(Dimension dimension);

/// Returns the name of the SI unit, "m"; empty for a ratio.
std::string si_unit(Dimension dimension);

/// Returns the SI value of `text`: a finite number followed by a unit of `dimension` (white space between
/// them is optional). Returns nothing for other text. A bare number is accepted for `ratio` only.
std::optional<double> parse_quantity(std::string_view text, Dimension dimension);

/// Parses a duration, for command lines and scripts. Returns whole nanoseconds; nothing for negative times.
std::optional<long long> parse_duration_ns(std::string_view text);

}  // namespace robosim
