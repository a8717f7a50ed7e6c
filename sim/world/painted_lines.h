// Models lines and marks that differ from the map's usual ones in width, colour, wear or gloss (map::Paint).
#pragma once

#include <cstddef>
#include <cstdint>
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
  /// Stores nothing if all lines have the usual paint without wear, or if the floor is a raster or an image.
  explicit PaintedLines(const map::Map& map);

  bool empty() const { return paints_.empty(); }

  /// Sets the noise that selects the places without paint.
  void wear(const NoiseStream& noise) { noise_ = noise; }

  /// Returns the reflectance in a band, relative to white, of a square of side `footprint` about p.
  /// `below` is the reflectance under the lines. `near` are the numbers of the `lines` that the square may
  /// touch. For each paint, in the order of their numbers,
  ///   r <- r + c t (r_paint - r)
  /// c is the largest share of the footprint that a stripe or mark of that paint covers (Floor::on_line). t
  /// is the share of the paint that wear has left at p.
  double over(double below, Band band, Vec2 p, double footprint, std::span<const std::uint32_t> near,
              std::span<const map::Stripe> lines, const PaintedMarks& marks) const;

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

  std::vector<Paint> paints_;
  NoiseStream noise_;
};

}  // namespace robosim::world
