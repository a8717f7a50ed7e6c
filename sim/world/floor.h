// The floor a robot drives on: how dark it is, and how far the line.
#pragma once

#include "sim/base/vec.h"
#include "sim/grid/map.h"

namespace robosim::world {

class Floor {
 public:
  /// The map must outlive the floor.
  explicit Floor(const grid::Map& map);

  /// The share of a sensor's footprint (diameter `footprint_m`) that lies on painted line, 0..1:
  ///   clamp((line/2 + f/2 - d) / f, 0, 1),  d = distance to the nearest painted centre line.
  /// Within 0.026 of the exact area of a disc on a straight edge.
  double coverage(Vec2 p, double footprint_m) const;

  /// Distance from p to the nearest centre line (painted or not), m; kFar or more where none is near.
  double distance_to_line(Vec2 p) const;

  /// distance_to_line is exact at least up to this, m.
  double far_m() const;
};

}  // namespace robosim::world
