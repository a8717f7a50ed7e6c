// Models the floor that a robot drives on: its darkness, and the distance to the line.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/base/noise.h"
#include "sim/base/profile.h"
#include "sim/base/vec.h"
#include "sim/map/floor_image.h"
#include "sim/map/map.h"
#include "sim/map/stripes.h"
#include "sim/world/floor_probe.h"
#include "sim/world/painted_areas.h"
#include "sim/world/painted_lines.h"
#include "sim/world/painted_marks.h"
#include "sim/world/runtime_paint.h"

namespace robosim::world {

/// Returns the default standard deviation of a floor's brightness, as a share of its mean. Two measured
/// floors have 0.05 and 0.15: docs/explanation/fidelity.md.
constexpr double typical_variation(Profile profile) { return profile < Profile::typical_2 ? 0.0 : 0.05; }

/// A floor is of one of two kinds. On a stripe floor, lines follow the centre lines of map::Stripes, with the
/// width `line` of the map. On a raster floor (the map has `floor = "raster"`), each painted line cell is
/// dark as a whole.
///
/// The first three functions examine a point p. Their `probe` caches what lies near p: pass the same probe on
/// every call for the same footprint. distance_to_line() needs a probe of its own.
class Floor {
 public:
  /// The map must outlive the floor. Throws InputError (map::Stripes).
  explicit Floor(const map::Map& map);

  /// Returns the share of the probe's footprint that lies on a painted line, 0..1. f is the footprint:
  ///   clamp((line/2 + f/2 - d) / f, 0, min(1, line/f)),  d = distance to the nearest painted centre line
  /// The result is exact for a square on a parallel stripe, and within 0.026 for a disc on an edge. On a
  /// raster floor it is the exact share of a square of side f. A segment wider than the map's line counts
  /// with its full width.
  double on_line(Vec2 p, const FloorProbe& probe) const {
    const double drawn = widths_.empty() ? line_share(p, probe) : wide_line_share(p, probe.footprint());
    return patches_.empty() ? drawn : patches_.over(drawn, 1.0, 0.0, p, probe.footprint());
  }

  /// Returns how dark a footprint appears in a band of light: 0 is white paper, 1 black. The value is
  /// negative if more light returns than from paper. On a floor with an image, the value is the image's mean
  /// darkness. On a floor with lines only, the value is the dark share of the footprint: the share on a dark
  /// line, or off a light line.
  ///
  /// Marks are painted like the line. Each area lies under or over lines and marks, and later areas cover
  /// earlier ones (map::Area). PaintedLines computes lines of other widths and colours, wear and gloss.
  double darkness(Vec2 p, const FloorProbe& probe, Band band = Band::infrared) const {
    if (!has_only_lines_ || !patches_.empty()) return painted_darkness(p.x, p.y, probe, band);
    const double line = line_share(p, probe);
    return light_line_ ? 1.0 - line : line;
  }

  /// Returns the distance from p to the nearest centre line (painted or not), m; far_m() or more if none is
  /// near.
  double distance_to_line(Vec2 p, const FloorProbe& probe = {}) const {
    const double nearest =
        probe.holds(p) ? probe.distance(stripes_.all(), p) : seek(p, false, kNoReach, probe);
    return nearest < stripes_reach_ ? nearest : search(p, false);
  }
  /// Returns the distance up to which distance_to_line is exact, m: three cells.
  double far_m() const { return kFarCells * cell_; }

  /// Makes some patches of the floor brighter, and others darker. brightness() then has the standard
  /// deviation `share`. The brightness of two points about 5 mm apart has a correlation of one half. With
  /// `share` 0, brightness() is 1 everywhere.
  void vary(const NoiseStream& noise, double share) {
    noise_ = noise;
    variation_ = share;
  }
  /// Returns whether brightness() differs between places.
  bool varies() const { return variation_ != 0.0; }
  /// Returns the light that the bare floor reflects at p, relative to its mean.
  double brightness(Vec2 p) const { return variation_ == 0.0 ? 1.0 : patch_brightness(p); }
  /// Removes the paint of worn lines at places drawn from `noise`.
  void wear(const NoiseStream& noise) { lines_.wear(noise); }

  /// Returns the paint that is added or removed during the run. It changes neither the map's centre lines nor
  /// the distances to them.
  RuntimePaint& patches() { return patches_; }
  const RuntimePaint& patches() const { return patches_; }
  const map::Stripes& stripes() const { return stripes_; }

 private:
  static constexpr int kFarCells = 3;
  static constexpr double kNoReach = FloorProbe::kNoStripe;

  // Finds the cell of a point; returns false outside the map. Rows count from the bottom.
  bool locate(Vec2 p, int& column, int& row) const {
    const double u = p.x * per_cell_, v = p.y * per_cell_;
    if (!(u >= 0.0 && v >= 0.0 && u < width_ && v < height_)) return false;
    column = static_cast<int>(u);
    row = static_cast<int>(v);
    return true;
  }
  std::span<const std::uint32_t> stripes_of(int column, int row) const {
    return stripes_.near({column, height_ - 1 - row});
  }
  double ramp(double distance, double reach, double footprint) const {
    const double t = (reach - distance) / footprint;
    const double most = footprint <= 2.0 * half_line_ ? 1.0 : 2.0 * half_line_ / footprint;
    return 0.5 * (std::fabs(t) - std::fabs(t - most) + most);  // clamps to 0..most without a branch
  }
  // The next functions ignore changes of paint during the run.
  double line_share(Vec2 p, const FloorProbe& probe) const {
    if (!probe.holds(p)) return sought_line_share(p, probe);
    if (probe.is_clear()) return 0.0;
    const double footprint = probe.footprint(), reach = half_line_ + 0.5 * footprint;
    return ramp(std::min(reach, probe.distance(stripes_.all(), p)), reach, footprint);
  }
  double sought_line_share(Vec2 p, const FloorProbe&) const;
  double wide_line_share(Vec2 p, double footprint) const;
  double raster_share(Vec2 p, double footprint) const;
  double drawn_darkness(Vec2 p, const FloorProbe&, Band) const;
  // Returns the darkness of a floor with more than lines. Not inline: inlining would slow down floors with
  // lines only. Takes x and y, because a Vec2 would be built in memory before each call.
  double painted_darkness(double x, double y, const FloorProbe&, Band) const;
  double patch_brightness(Vec2 p) const;

  double seek(Vec2 p, bool painted_only, double reach, const FloorProbe&) const;
  double search(Vec2 p, bool painted_only) const;
  std::span<const std::uint32_t> touched_stripes(Vec2 p, double footprint) const;

  const map::Map& map_;
  const int width_, height_;
  const double cell_, per_cell_, half_line_;
  const double widest_;         // in metres: width of the widest line
  const double stripes_reach_;  // in metres; a cell lists all stripes nearer than this to one of its points
  const map::Stripes stripes_;
  const bool light_line_;
  const map::FloorImage* const image_;  // null = none
  const PaintedMarks marks_;
  const PaintedAreas areas_;
  PaintedLines lines_;
  RuntimePaint patches_;
  const double gloss_;
  const bool is_uniform_;      // only lines and marks, all with the usual paint, none worn or glossy
  const bool has_only_lines_;  // uniform, and without marks
  NoiseStream noise_;
  double variation_ = 0.0;
  std::vector<double> widths_;  // m, line width of each paint; empty if none exceeds the map's width
  std::vector<std::uint32_t> all_stripes_;  // numbers of all stripes, if paints differ or are worn
};

}  // namespace robosim::world
