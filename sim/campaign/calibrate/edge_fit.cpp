#include "sim/campaign/calibrate/edge_fit.h"

#include <algorithm>
#include <cmath>

#include "sim/campaign/calibrate/optimise.h"

namespace robosim::calibrate {
namespace {

constexpr double kLeastFootprint = 0.0005, kMostFootprint = 0.03;  // in metres: limits in a robot file

}  // namespace

double share_on_tape(double inwards, double footprint, double tape_m) {
  const double distance = std::fabs(0.5 * tape_m - inwards);
  return std::clamp((0.5 * (tape_m + footprint) - distance) / footprint, 0.0,
                    std::min(1.0, tape_m / footprint));
}

EdgeFit at_offset(const Edge& edge, double offset, double footprint, double tape_m) {
  double up = 0.0, down = 1e-30;
  for (std::size_t i = 0; i < edge.s.size(); ++i) {
    const double c = share_on_tape(edge.s[i] - offset, footprint, tape_m);
    up += (1.0 - c) * (edge.y[i] - edge.black * c);
    down += (1.0 - c) * (1.0 - c);
  }
  const double white = up / down;
  double sse = 0.0;
  for (std::size_t i = 0; i < edge.s.size(); ++i) {
    const double c = share_on_tape(edge.s[i] - offset, footprint, tape_m);
    const double error = (edge.y[i] - white * (1.0 - c) - edge.black * c) / (edge.black - white);
    sse += error * error;
  }
  return {sse, white};
}

// Searches on a coarse grid, then by golden section.
double best_offset(const Edge& edge, double footprint, double tape_m) {
  const double reach = 0.0006 + 0.25 * footprint;
  constexpr int kLooks = 4;
  double best = 0.0, least = 1e300;
  for (int k = -kLooks; k <= kLooks; ++k) {
    const double offset = reach * k / kLooks;
    const double sse = at_offset(edge, offset, footprint, tape_m).sse;
    if (sse < least) {
      least = sse;
      best = offset;
    }
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = best - reach / kLooks, high = best + reach / kLooks;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = at_offset(edge, a, footprint, tape_m).sse, at_b = at_offset(edge, b, footprint, tape_m).sse;
  for (int round = 0; round < 14; ++round) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = at_offset(edge, a, footprint, tape_m).sse;
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = at_offset(edge, b, footprint, tape_m).sse;
    }
  }
  return 0.5 * (low + high);
}

double fit_footprint(const std::vector<Edge>& edges, std::size_t first, std::size_t stride, double start,
                     double tape_m) {
  const auto misfit = [&](const std::vector<double>& x) {
    const double footprint = std::exp(x[0]);
    double sum = 0.0;
    for (std::size_t i = first; i < edges.size(); i += stride)
      sum += at_offset(edges[i], best_offset(edges[i], footprint, tape_m), footprint, tape_m).sse;
    return sum;
  };
  return std::exp(
      minimise(misfit, {{std::log(kLeastFootprint), std::log(kMostFootprint), std::log(start), 0.3}}, 40)[0]);
}

}  // namespace robosim::calibrate
