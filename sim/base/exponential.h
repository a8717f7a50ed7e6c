// Computes exponentials and logarithms with the same bits on every machine, unlike libm.
#pragma once

#include <cmath>

namespace robosim {

/// Returns e^-x for x >= 0; error below 1e-15. Multiplies the nearest power of two by a Taylor series.
inline double decay_of(double x) {
  constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33, kMost = 700.0;
  if (!(x < kMost)) return 0.0;
  const double halvings = std::floor(x / (kLn2High + kLn2Low) + 0.5);
  const double r = halvings * kLn2High - x + halvings * kLn2Low;
  double sum = 1.0;
  for (int n = 14; n >= 1; --n) sum = 1.0 + r / n * sum;
  return std::ldexp(sum, -static_cast<int>(halvings));
}

/// Returns the natural logarithm of x > 0; error below 1e-15 (1 + |ln x|). Uses the series of artanh.
inline double log_of(double x) {
  constexpr double kLn2 = 0.69314718055994531, kRootHalf = 0.70710678118654752;
  int doublings = 0;
  double mantissa = std::frexp(x, &doublings);
  if (mantissa < kRootHalf) {
    mantissa *= 2.0;
    --doublings;
  }
  const double s = (mantissa - 1.0) / (mantissa + 1.0), s2 = s * s;
  double sum = 0.0;
  for (int n = 21; n >= 1; n -= 2) sum = sum * s2 + 1.0 / n;
  return 2.0 * s * sum + doublings * kLn2;
}

}  // namespace robosim
