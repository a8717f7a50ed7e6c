// Converts angles to directions, like deterministic_trig.h, but with fewer terms of the series and a larger
// error. The bits are the same on every machine, unlike those of libm's sine and cosine.
#pragma once

#include <cmath>
#include <numbers>

#include "sim/base/vec.h"

namespace robosim {

/// Returns (cos a, sin a), computed by series about the nearest quarter turn. The error is below 1e-13 for
/// angles of a few turns.
inline Vec2 direction_of(double radians) {
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  const double quarters = std::floor(radians / kQuarter + 0.5);
  const double r = radians - quarters * kQuarter, s = r * r;
  const double sine =
      r * (1 - s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156))))));
  const double cosine =
      1 - s / 2 * (1 - s / 12 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132 * (1 - s / 182))))));
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace robosim
