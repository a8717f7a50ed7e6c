// Models lines and marks that differ from the map's usual ones: other widths or colours, worn, or glossy
// (map::Paint).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/base/noise.h"
#include "sim/map/map.h"
#include "sim/map/stripes.h"
#include "sim/world/painted_areas.h"
#include "sim/world/painted_marks.h"

namespace robosim::world {

class PaintedLines {
 public:
  /// Stores nothing for a map whose lines all have the usual paint and no wear. The map must outlive this
  /// object. Pass the same `marks` to over().
  PaintedLines(const map::Map& map, const PaintedMarks& marks);

  bool empty() const { return !stripes_; }

  /// Sets the noise that selects the places without paint.
  void wear(const NoiseStream& noise) { noise_ = noise; }

  /// Returns the reflectance in a band, relative to white, of a square of side `footprint` about p.
  /// `below` is the reflectance under the lines. For each paint, in the order of their numbers,
  ///   r <- r + c t (r_paint - r)
  /// c is the largest share of the footprint that a stripe or mark of that paint covers (Floor::coverage). t
  /// is the share of the paint that wear has left at p.
  double over(double below, Band band, Vec2 p, double footprint, const PaintedMarks& marks) const {
    if (footprint > kLookedUpFootprint) return over_these(all_, below, band, p, footprint, marks);
    const double u = p.x * per_cell_, v = p.y * per_cell_;
    if (!(u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_)) return below;
    const auto near = index_.near({static_cast<int>(u), last_row_ - static_cast<int>(v)});
    if (near.empty()) return below;
    return over_these(near, below, band, p, footprint, marks);
  }

  /// Returns the remaining share of paint at p, 0..1, if the share `worn` is gone. At each point of a 10 mm
  /// lattice the paint is whole or gone. In between, the share is smoothly interpolated from four points. The
  /// mean share over a long line is therefore 1 - worn. Paint that is gone at a small `worn` is also gone
  /// at a larger `worn`.
  double left(Vec2 p, double worn) const;

 private:
  struct Paint {
    double width, worn;
    double back[4];  // reflectance in each band
  };

  static constexpr double kLookedUpFootprint = 0.016;  // m; larger footprints check all stripes and marks

  double over_these(std::span<const std::uint32_t> near, double below, Band, Vec2 p, double footprint,
                    const PaintedMarks&) const;

  double columns_, rows_, per_cell_;
  int last_row_;
  std::vector<Paint> paints_;
  double reach_ = 0.0;  // m
  std::unique_ptr<map::Stripes> stripes_;
  map::StripeIndex index_;          // indexes stripes_, then the marks
  std::vector<std::uint32_t> all_;  // numbers of all stripes and marks
  NoiseStream noise_;
};

}  // namespace robosim::world
