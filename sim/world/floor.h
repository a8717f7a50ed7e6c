// Models the floor that a robot drives on: its darkness, and the distance to the line.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "sim/base/noise.h"
#include "sim/base/profile.h"
#include "sim/base/vec.h"
#include "sim/map/floor_image.h"
#include "sim/map/map.h"
#include "sim/map/stripes.h"
#include "sim/world/near_stripe.h"
#include "sim/world/painted_areas.h"
#include "sim/world/painted_lines.h"
#include "sim/world/painted_marks.h"
#include "sim/world/runtime_paint.h"

namespace robosim::world {

/// Returns the default standard deviation of a floor's brightness, as a share of its mean. Two measured
/// floors have 0.05 and 0.15: docs/explanation/fidelity.md.
constexpr double typical_variation(Profile profile) { return profile < Profile::typical_2 ? 0.0 : 0.05; }

/// A floor has one of two kinds. On a stripe floor, lines of the map's width `line` follow the centre lines
/// of map::Stripes. On a raster floor (the map has `floor = "raster"`), each painted line cell is dark as a
/// whole.
///
/// One byte per cell describes the lines that a query inside the cell can meet. Most queries therefore cost
/// one load and one square root. The byte depends on the kind of floor:
///   square corners: which of its four arms (half stripes from its centre to its sides) the cell has,
///                   and whether they are painted; no stripe of another cell is nearer than cell / 2
///   round corners:  no byte; map::StripeIndex lists the few stripes near the cell, if any
///   raster:         which cells of a 2x2 neighbourhood are dark
class Floor {
 public:
  /// The map must outlive the floor.
  explicit Floor(const map::Map& map);

  /// Returns the share of a sensor's footprint that lies on a painted line, 0..1. `footprint_m` is f: the
  /// side of a square footprint, or of the square that has the same area as a disc (diameter 1.13 f).
  ///   clamp((line/2 + f/2 - d) / f, 0, min(1, line/f)),  d = distance to the nearest painted centre line
  /// The result is exact for a square on a parallel stripe, and within 0.026 for a disc on an edge. On a
  /// raster floor it is the exact share of a square of side f.
  double coverage(Vec2 p, double footprint_m) const {
    const double drawn = drawn_coverage(p, footprint_m);
    return patches_.empty() ? drawn : patches_.over(drawn, 1.0, 0.0, p, footprint_m);
  }

  /// Cached variant: pass the same `last` and footprint on every call, also to the functions below.
  double coverage(Vec2 p, double footprint_m, NearStripe& last) const {
    const double drawn = drawn_coverage(p, footprint_m, last);
    return patches_.empty() ? drawn : patches_.over(drawn, 1.0, 0.0, p, footprint_m);
  }

  /// Returns the share of the footprint on the visible line: a segment wider than the map's line counts with
  /// its full width.
  double on_line(Vec2 p, double footprint_m) const {
    NearStripe unknown;
    return on_line(p, footprint_m, unknown);
  }
  double on_line(Vec2 p, double footprint_m, NearStripe& last) const {
    if (widths_.empty()) return coverage(p, footprint_m, last);
    const double drawn = on_wide_line(p, std::max(footprint_m, 1e-9));
    return patches_.empty() ? drawn : patches_.over(drawn, 1.0, 0.0, p, footprint_m);
  }

  /// Returns how dark a footprint appears to a reflectance sensor: 0 is white paper, 1 black. The value is
  /// negative if more light returns than from paper. On a floor with an image, the value is the image's mean
  /// darkness. On a floor with lines only, the value is the dark share of the footprint: the share on a dark
  /// line, or off a light line.
  ///
  /// Marks are painted like the line. Each area lies under or over lines and marks, and later areas cover
  /// earlier ones (map::Area). PaintedLines computes lines of other widths and colours, wear and gloss.
  double darkness(Vec2 p, double footprint_m) const {
    if (plain_) {
      const double painted = drawn_coverage(p, footprint_m);
      return light_line_ ? 1.0 - painted : painted;
    }
    return painted_darkness(p.x, p.y, footprint_m);
  }
  double darkness(Vec2 p, double footprint_m, NearStripe& last) const {
    if (plain_) return darkness_of(drawn_coverage(p, footprint_m, last));
    return painted_darkness(p.x, p.y, footprint_m);
  }
  /// Converts on_line() to darkness(). Valid only if has_lines_only().
  double darkness_of(double on_line) const { return light_line_ ? 1.0 - on_line : on_line; }
  bool has_lines_only() const { return plain_ && widths_.empty(); }
  /// Returns the darkness in one band of light.
  double darkness(Vec2 p, double footprint_m, Band band) const {
    return patched(drawn_darkness(p, footprint_m, band), p, footprint_m);
  }

  /// Makes some patches of the floor brighter, and others darker. brightness() then has the standard
  /// deviation `share`. Its correlation is one half at about 5 mm. With `share` 0, brightness() is 1
  /// everywhere.
  void vary(const NoiseStream& noise, double share) {
    noise_ = noise;
    variation_ = share;
  }
  /// Removes the paint of worn lines at places drawn from `noise`.
  void wear(const NoiseStream& noise) { lines_.wear(noise); }
  /// Returns whether brightness() differs between places.
  bool varies() const { return variation_ != 0.0; }
  /// Returns the light that the bare floor reflects at p, relative to its mean.
  double brightness(Vec2 p) const { return variation_ == 0.0 ? 1.0 : patch_brightness(p); }

  /// Returns the paint that is added or removed during the run. It changes neither the map's centre lines nor
  /// the distances to them.
  RuntimePaint& patches() {
    plain_ = marked_ = false;
    return patches_;
  }
  void restore(const RuntimePaint::State& patches) {
    patches_.restore(patches);
    plain_ = alike_ && marks_.empty() && patches_.empty();
    marked_ = with_marks_ && patches_.empty();
  }
  const RuntimePaint& patches() const { return patches_; }
  double line_width() const { return 2.0 * half_line_; }

  /// Returns the distance from p to the nearest centre line (painted or not), m; far_m() or more if none is
  /// near.
  double distance_to_line(Vec2 p) const;
  /// Cached variant: pass the same `last` on every call.
  double distance_to_line(Vec2 p, NearStripe& last) const;

  /// Returns the distance up to which distance_to_line is exact, m: three cells.
  double far_m() const { return kFarCells * cell_; }

 private:
  static constexpr int kFarCells = 3;

  // A horizontal and a vertical segment about a cell's centre, m.
  struct Arms {
    double west, east, south, north;
    double square(double x, double y) const {
      const double dx = x - std::min(std::max(x, west), east);
      const double dy = y - std::min(std::max(y, south), north);
      return std::min(dx * dx + y * y, x * x + dy * dy);
    }
  };
  // The meaning of a cell's byte.
  struct Kind {
    Arms line;     // centre lines in the cell, painted or not
    Arms painted;  // painted centre lines, shortened towards a gap
    bool is_line, is_painted;
  };

  // Finds the cell of a point; returns false outside the map. Rows count from the bottom.
  bool locate(Vec2 p, int& column, int& row, double& x, double& y) const {
    const double u = p.x * per_cell_, v = p.y * per_cell_;
    if (!(u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_)) return false;
    column = static_cast<int>(u);
    row = static_cast<int>(v);
    x = p.x - (column + 0.5) * cell_;
    y = p.y - (row + 0.5) * cell_;
    return true;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }
  double ramp(double distance, double reach, double footprint) const {
    const double t = (reach - distance) / footprint;
    const double most = footprint <= 2.0 * half_line_ ? 1.0 : 2.0 * half_line_ / footprint;
    return 0.5 * (std::fabs(t) - std::fabs(t - most) + most);  // clamps to 0..most without a branch
  }
  double patch_brightness(Vec2 p) const;
  /// Returns the coverage by the map's lines, without changes of paint during the run.
  double drawn_coverage(Vec2 p, double footprint_m) const;
  double drawn_coverage(Vec2 p, double footprint_m, NearStripe& last) const;
  /// Returns the darkness after changes of paint during the run; `darkness` is the value without them.
  double patched(double darkness, Vec2 p, double footprint) const {
    if (patches_.empty()) return darkness;
    return patches_.over(darkness, light_line_ ? 0.0 : 1.0, light_line_ ? 1.0 : 0.0, p, footprint);
  }
  // Returns the darkness of a floor with more than lines. The function is not inline, because it would slow
  // down floors with lines only. It takes x and y, because a Vec2 would be built in memory before each call.
  double painted_darkness(double x, double y, double footprint_m) const;
  double other_darkness(double x, double y, double footprint_m) const;
  double darkness_of_paint(Vec2 p, double footprint) const;
  // Returns the darkness without changes of paint during the run.
  double drawn_darkness(Vec2 p, double footprint_m) const {
    if (alike_) {
      const double painted = painted_share(p, footprint_m);
      return light_line_ ? 1.0 - painted : painted;
    }
    return paints_only_ ? 1.0 - lines_.over((light_line_ ? 0.0 : 1.0) + gloss_, Band::infrared, p,
                                            std::max(footprint_m, 1e-9), marks_)
                        : darkness_of_paint(p, footprint_m);
  }
  double drawn_darkness(Vec2 p, double footprint_m, Band band) const;
  double painted_share(Vec2 p, double footprint) const {
    const double lines = drawn_coverage(p, footprint);
    return marks_.any_near(p, footprint) ? std::max(lines, marks_.coverage(p, std::max(footprint, 1e-9)))
                                         : lines;
  }

  void read_stripes(const map::Map& map);
  void read_raster(const map::Map& map);
  void index_with_marks(const map::Map& map);
  double search(Vec2 p, bool painted_only) const;
  double square_in(int column, int row, Vec2 p, bool painted_only) const;
  double coverage_round(Vec2 p, double footprint) const;
  double sought_coverage(Vec2 p, double footprint, NearStripe& found) const;
  double sought_distance(Vec2 p, NearStripe& found) const;
  double seek(Vec2 p, bool painted_only, double reach, NearStripe& found) const;
  double on_wide_line(Vec2 p, double footprint) const;
  double coverage_raster(Vec2 p, double footprint) const;

  int width_, height_;
  double columns_, rows_;
  double cell_, per_cell_, half_line_;
  const map::Map* map_;
  const bool light_line_;
  const map::FloorImage* const image_;  // null = none
  const PaintedMarks marks_;
  const PaintedAreas areas_;
  PaintedLines lines_;
  RuntimePaint patches_;
  const double gloss_;
  const bool alike_;        // only lines and marks, all with the usual paint, none worn or glossy
  bool plain_;              // alike_, without marks and changes of paint: a faster path
  bool marked_;             // alike_, with marks: lines and marks are looked up together
  const bool paints_only_;  // only lines and marks, with several paints, worn or glossy
  NoiseStream noise_;
  double variation_ = 0.0;
  std::array<Kind, 98> kinds_;
  std::vector<std::uint8_t> cells_;  // square corners: numbers of kinds_, row by row from the bottom
  double stripes_reach_ = 0.0;
  std::unique_ptr<map::Stripes> stripes_;  // round corners
  // Indexes stripes_, followed by marks_. Exists only if alike_ is set, and the floor has marks and round
  // corners, and is not a raster; else null.
  std::unique_ptr<map::StripeIndex> with_marks_;
  std::vector<double> widths_;       // m, line width of each paint; empty if none exceeds the map's width
  std::vector<std::uint8_t> quads_;  // raster: bits SW SE NW NE; one more row and column than the map
};

inline double Floor::drawn_coverage(Vec2 p, double footprint_m) const {
  const double footprint = std::max(footprint_m, 1e-9);
  if (!quads_.empty()) return coverage_raster(p, footprint);
  const double reach = half_line_ + 0.5 * footprint;
  if (stripes_ && reach <= stripes_reach_) return coverage_round(p, footprint);
  if (stripes_ || reach > 0.5 * cell_) return ramp(search(p, true), reach, footprint);
  int column, row;
  double x, y;
  if (!locate(p, column, row, x, y)) return 0.0;
  const Kind& kind = kinds_[cells_[index(column, row)]];
  if (!kind.is_painted) return kind.is_line ? ramp(search(p, true), reach, footprint) : 0.0;
  const double square = kind.painted.square(x, y);
  if (square >= reach * reach) return 0.0;
  return ramp(std::sqrt(square), reach, footprint);
}

inline double Floor::drawn_coverage(Vec2 p, double footprint_m, NearStripe& last) const {
  if (!stripes_ || !quads_.empty()) return drawn_coverage(p, footprint_m);
  if (!last.holds(p)) return sought_coverage(p, footprint_m, last);
  if (last.is_clear()) return 0.0;
  const double footprint = std::max(footprint_m, 1e-9), reach = half_line_ + 0.5 * footprint;
  return ramp(std::min(reach, last.distance(stripes_->all(), p)), reach, footprint);
}

inline double Floor::distance_to_line(Vec2 p, NearStripe& last) const {
  if (!last.holds(p)) return sought_distance(p, last);
  const double nearest = last.distance(stripes_->all(), p);
  return nearest < stripes_reach_ ? nearest : sought_distance(p, last);
}

inline double Floor::distance_to_line(Vec2 p) const {
  int column, row;
  double x, y;
  if (!locate(p, column, row, x, y)) return search(p, false);
  if (stripes_) {
    double nearest = stripes_reach_;
    for (const std::uint32_t i : stripes_->near({column, height_ - 1 - row}))
      nearest = std::min(nearest, map::distance(stripes_->all()[i], p));
    if (nearest < stripes_reach_) return std::sqrt(nearest * nearest);
  } else if (const Kind& kind = kinds_[cells_[index(column, row)]]; kind.is_line) {
    const double square = kind.line.square(x, y);
    if (square <= 0.25 * cell_ * cell_) return std::sqrt(square);
  }
  return search(p, false);
}

}  // namespace robosim::world
