// Quantities as people write them: "150 mm", "7.4 V", "60s". Internally everything is SI.
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

/// The unit names of a dimension, as messages list them: "mm, cm, m or in".
std::string unit_names(Dimension dimension);

/// Of the SI unit itself: "m"; empty for a ratio.
std::string si_unit(Dimension dimension);

/// The SI value of `text`; nothing if it is not a finite number followed by a unit of `dimension` (white
/// space between them does not matter). A bare number is taken for `ratio` only.
std::optional<double> parse_quantity(std::string_view text, Dimension dimension);

/// As parse_quantity in exact nanoseconds, for command lines and scripts; rejects negative times.
std::optional<long long> parse_duration_ns(std::string_view text);

}  // namespace robosim
