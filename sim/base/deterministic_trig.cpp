#include "sim/base/deterministic_trig.h"

#include <cmath>
#include <numbers>

namespace robosim {
namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

// Computes a sine by its Taylor series about 0, for at most an eighth of a turn. The remainder is below
// 1e-19.
double sine(double x) {
  double term = x, sum = x;
  for (int n = 2; n <= 18; n += 2) sum += term *= -x * x / (n * (n + 1));
  return sum;
}
double cosine(double x) {
  double term = 1.0, sum = 1.0;
  for (int n = 1; n <= 19; n += 2) sum += term *= -x * x / (n * (n + 1));
  return sum;
}

}  // namespace

Vec2 unit_vector(double angle) {
  const double quarters = std::floor(angle / kQuarter + 0.5);
  const double rest = angle - quarters * kQuarter;
  Vec2 v{cosine(rest), sine(rest)};
  const int turns = static_cast<int>(std::fmod(quarters, 4.0) + 4.0) % 4;
  for (int i = 0; i < turns; ++i) v = left_of(v);
  return v;
}

double angle_of(Vec2 v) {
  // Applies Newton's method from the middle of the quadrant. The cross product is the sine of the remaining
  // angle.
  double angle = v.y >= 0.0 ? (v.x >= 0.0 ? 0.5 : 1.5) * kQuarter : (v.x >= 0.0 ? -0.5 : -1.5) * kQuarter;
  const double size = length(v);
  if (size == 0.0) return 0.0;
  for (int i = 0; i < 8; ++i) {
    const double missing = cross(unit_vector(angle), v) / size;
    angle += missing * (1.0 + missing * missing / 6.0);
  }
  return angle;
}

}  // namespace robosim
