// Lines and marks that differ from the map's usual ones: of other widths and colours, worn, or glossy
// (grid::Paint).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/base/noise.h"
#include "sim/grid/map.h"
#include "sim/grid/stripes.h"
#include "sim/world/painted_areas.h"
#include "sim/world/painted_marks.h"

namespace robosim::world {

class PaintedLines {
 public:
  /// Holds nothing for a map whose lines are alike and whole. The map must outlive this; `marks` are those of
  /// over().
  PaintedLines(const grid::Map& map, const PaintedMarks& marks);

  bool empty() const { return !stripes_; }

  /// Where paint is gone is drawn from `noise`.
  void wear(const NoiseStream& noise) { noise_ = noise; }

  /// Returns the reflectance of a band, as a share of white's, in a square of side `footprint` about p.
  /// `below` is the reflectance under the lines. For each paint, in the order of their numbers,
  ///   r <- r + c t (r_paint - r)
  /// c: the largest share of the footprint that one stripe or mark of that paint takes, as
  /// Floor::coverage has it; t: what is left of the paint there.
  double over(double below, Band band, Vec2 p, double footprint, const PaintedMarks& marks) const {
    if (footprint > kLookedUpFootprint) return over_these(all_, below, band, p, footprint, marks);
    const double u = p.x * per_cell_, v = p.y * per_cell_;
    if (!(u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_)) return below;
    const auto near = index_.near({static_cast<int>(u), last_row_ - static_cast<int>(v)});
    if (near.empty()) return below;
    return over_these(near, below, band, p, footprint, marks);
  }

  /// Returns the remaining share of paint at p, 0..1, if the share `worn` is gone. At each point of a lattice
  /// of 10 mm it is whole or gone; in between it is the smooth mean of four points. So its mean over
  /// a long line is 1 - worn. Paint that is gone at a smaller `worn` is gone at a larger one.
  double left(Vec2 p, double worn) const;

 private:
  struct Paint {
    double width, worn;
    double back[4];  // what comes back of each band
  };

  static constexpr double kLookedUpFootprint = 0.016;  // m; larger ones look at all

  double over_these(std::span<const std::uint32_t> near, double below, Band, Vec2 p, double footprint,
                    const PaintedMarks&) const;

  double columns_, rows_, per_cell_;
  int last_row_;
  std::vector<Paint> paints_;
  double reach_ = 0.0;  // m
  std::unique_ptr<grid::Stripes> stripes_;
  grid::StripeIndex index_;         // of them, then of the marks
  std::vector<std::uint32_t> all_;  // all numbers
  NoiseStream noise_;
};

}  // namespace robosim::world
