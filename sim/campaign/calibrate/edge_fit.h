// Fits the edges of a tape in a sensor's readings, and the footprint of the sensor. The top of sweep_fit.h
// describes the model.
#pragma once

#include <cstddef>
#include <vector>

namespace robosim::calibrate {

/// The samples across one side of the tape.
struct Edge {
  std::vector<double> s, y;  // s: position inwards from the edge, m; y: signal
  double black;              // the signal over black
};

/// The result of a fit: the sum of squared errors, relative to the step from white to black, and the best
/// signal over white.
struct EdgeFit {
  double sse, white;
};

/// Returns the share of the footprint that is on the tape. `inwards` is the distance, m, of the sensor from
/// the tape's edge, positive inside the tape.
double share_on_tape(double inwards, double footprint, double tape_m);

/// Returns the fit with the edge moved inwards by `offset`.
EdgeFit at_offset(const Edge& edge, double offset, double footprint, double tape_m);

/// Returns the offset with the smallest error.
double best_offset(const Edge& edge, double footprint, double tape_m);

/// Returns the best footprint (m) for the edges first, first + stride, …. The search begins at `start`.
double fit_footprint(const std::vector<Edge>& edges, std::size_t first, std::size_t stride, double start,
                     double tape_m);

}  // namespace robosim::calibrate
