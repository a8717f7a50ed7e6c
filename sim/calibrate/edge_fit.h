// The edges of a tape in a sensor's readings, and the footprint that follows from them. The model is at the
// top of sweep_fit.h.
#pragma once

#include <cstddef>
#include <vector>

namespace robosim::calibrate {

/// The samples across one side of the tape.
struct Edge {
  std::vector<double> s, y;  // m inwards, signal
  double black;              // the signal over black
};

/// The quality of a fit: the sum of squared errors, as shares of white to black, and the best signal over
/// white.
struct EdgeFit {
  double sse, white;
};

/// Returns the share of the footprint on the tape, `inwards` of its edge.
double share_on_tape(double inwards, double footprint, double tape_m);

/// Fits with the edge `offset` further inwards.
EdgeFit at_offset(const Edge& edge, double offset, double footprint, double tape_m);

/// Returns the best offset.
double best_offset(const Edge& edge, double footprint, double tape_m);

/// Returns the best footprint (m) for edges first, first + stride, …; the search begins at `start`.
double fit_footprint(const std::vector<Edge>& edges, std::size_t first, std::size_t stride, double start,
                     double tape_m);

}  // namespace robosim::calibrate
