// The painted lines of a map as geometry: segments between centres of line cells, and arcs where `corner` rounds
// a bend. The floor's reflectance and the cross-track error are both measured against these.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::grid {

/// A piece of centre line, in the world frame (m).
struct Stripe {
  Vec2 a;               ///< one end
  Vec2 b;               ///< the other end
  Vec2 centre;          ///< of the arc's circle
  double radius = 0.0;  ///< of the arc; 0 = a straight segment
  bool painted = true;  ///< false across gap cells: part of the line that is followed, but not visible
};

/// A bend whose legs are too short for the map's corner radius; it was left with a smaller one.
struct TightBend {
  CellAt cell;
  double radius_m;  ///< what fits
};

/// All stripes, and for each cell those that pass within reach of it.
class Stripes {
 public:
  /// `reach_m`: a query point in a cell finds every stripe that is at most this far from the point.
  Stripes(const Map& map, double reach_m);

  std::span<const Stripe> all() const { return stripes_; }
  /// Indices into all() of the stripes within reach of any point of the cell; empty outside the map.
  std::span<const std::uint32_t> near(CellAt cell) const;
  /// The point of the centre line that stands for a line cell: its centre, or where an arc cuts the corner, the
  /// arc's nearest point to it.
  Vec2 point_of(CellAt cell) const;
  const std::vector<TightBend>& tight_bends() const { return tight_; }

 private:
  std::vector<Stripe> stripes_;
  std::vector<std::uint32_t> first_;  // CSR: per cell, the beginning of its slice of index_
  std::vector<std::uint32_t> index_;
  std::vector<TightBend> tight_;
  const Map* map_;
};

/// Distance from p to the nearest point of a stripe, m. No trigonometry: safe inside a tick.
double distance(const Stripe& stripe, Vec2 p);

}  // namespace robosim::grid
