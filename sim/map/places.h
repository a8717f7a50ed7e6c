// Finds the landmark at which a robot is: the nearest station or junction, measured along the line.
//
// A robot within 0.3 cells of the middle between two landmarks is at neither.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"

namespace robosim::map {

class Places {
 public:
  /// Finds the stations and junctions that are reachable from `start`. The map must outlive this object.
  Places(const Map& map, const Start& start);

  /// Returns "station 3", "station dock", "junction 2"; empty if the point (world frame, m) is between two
  /// landmarks, or there are no landmarks.
  std::string at(Vec2 point) const;
  /// Returns the distance in cells from the point to the nearest piece of line. Treats bends as square
  /// corners.
  double cells_off(Vec2 point) const;

 private:
  static constexpr std::int32_t kNone = -1;
  /// The two nearest landmarks of a cell, and their distances in cells along the line.
  struct Near {
    std::array<std::int32_t, 2> landmark{kNone, kNone};
    std::array<std::int32_t, 2> cells{};
  };

  void spread(const std::vector<CellAt>& landmarks);
  CellAt line_cell_near(Vec2 point) const;
  /// A place on the line: on a cell, or at a share of the distance between two cells (0..1).
  struct OnLine {
    CellAt cell{-1, -1};
    CellAt next{-1, -1};
    double along = 0.0;
  };
  OnLine nearest(Vec2 point) const;

  const Map& map_;
  std::vector<std::string> names_;
  std::vector<Near> near_;
};

}  // namespace robosim::map
