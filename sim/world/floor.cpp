#include "sim/world/floor.h"

#include <numeric>

namespace robosim::world {
namespace {

// Largest footprint, m, for which a floor looks up only nearby stripes.
constexpr double kUsualFootprint = 0.016;

constexpr double kPatch = 0.010;  // m between the sample points of a floor's brightness

double widest_line(const map::Map& map) {
  double widest = map.line_m;
  for (const map::Paint& paint : map.course.paints) widest = std::max(widest, paint.width);
  return widest;
}

// Lines with square corners run through the centres of cells, so they are at least half a cell away from
// other cells. With a reach that is shorter than half a cell by kAside, a cell lists only its own lines.
constexpr double kAside = 1e-6;  // m
bool is_square(const map::Map& map) { return map.corner_m == 0.0 && map.course.paths.empty(); }

double reach_of(const map::Map& map) {
  return is_square(map) ? 0.5 * map.cell_m : 0.5 * widest_line(map) + 0.5 * kUsualFootprint;
}

// Returns the distance from p to a straight stripe of a floor with square corners. Next to a gap, the paint
// ends at the distance `beyond` past the centre of the stripe's last cell. This function uses that end
// instead of the stripe's own.
double square_distance(const map::Stripe& s, Vec2 p, double cell, double beyond) {
  const auto outside = [&](double a, double b, double at) {
    const double first = (std::floor(a / cell) + 0.5) * cell, last = (std::floor(b / cell) + 0.5) * cell;
    const double before = std::fabs(a - first) < 0.01 * cell ? a - at : first - at - beyond;
    const double after = std::fabs(b - last) < 0.01 * cell ? at - b : at - last - beyond;
    return std::max(std::max(before, after), 0.0);
  };
  const double dx = outside(s.a.x, s.b.x, p.x), dy = outside(s.a.y, s.b.y, p.y);
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Floor::Floor(const map::Map& map)
    : map_(map),
      width_(map.width),
      height_(map.height),
      cell_(map.cell_m),
      per_cell_(1.0 / map.cell_m),
      half_line_(0.5 * map.line_m),
      widest_(widest_line(map)),
      stripes_reach_(reach_of(map)),
      stripes_(map, is_square(map) ? stripes_reach_ - kAside : stripes_reach_),
      light_line_(map.light_line),
      image_(map.image.get()),
      marks_(map),
      areas_(map),
      lines_(map),
      gloss_(map.gloss),
      is_uniform_(areas_.empty() && lines_.empty() && !image_ && gloss_ == 0.0),
      has_only_lines_(is_uniform_ && marks_.empty()) {
  if (widest_ > map.line_m && !map.raster)
    for (const map::Paint& paint : map::paints_of(map)) widths_.push_back(std::max(paint.width, map.line_m));
  if (lines_.empty() && widths_.empty()) return;
  all_stripes_.resize(stripes_.all().size());
  std::iota(all_stripes_.begin(), all_stripes_.end(), 0u);
}

[[gnu::noinline]] double Floor::painted_darkness(double x, double y, const FloorProbe& probe,
                                                 Band band) const {
  const Vec2 p{x, y};
  FloorProbe::Darkness& last = probe.last_darkness();
  if (last.at.x == x && last.at.y == y && last.band == band && last.changes == patches_.changes())
    return last.value;
  double darkness = drawn_darkness(p, probe, band);
  if (!patches_.empty())
    darkness =
        patches_.over(darkness, light_line_ ? 0.0 : 1.0, light_line_ ? 1.0 : 0.0, p, probe.footprint());
  last = {p, band, patches_.changes(), darkness};
  return darkness;
}

double Floor::drawn_darkness(Vec2 p, const FloorProbe& probe, Band band) const {
  const double footprint = std::max(probe.footprint(), image_ ? 1e-6 : 1e-9);
  if (image_) {
    const double darkness = image_->darkness(p, footprint);
    if (areas_.empty() && gloss_ == 0.0) return darkness;
    const double under = areas_.over(1.0 - darkness + gloss_, false, band, p, footprint);
    return 1.0 - areas_.over(under, true, band, p, footprint);
  }
  const auto painted_share = [&] {
    const double line = line_share(p, probe);
    return marks_.empty() ? line : std::max(line, marks_.coverage(p, footprint));
  };
  if (is_uniform_) return light_line_ ? 1.0 - painted_share() : painted_share();
  const double line = light_line_ ? 1.0 : 0.0;
  double back = areas_.over(1.0 - line + gloss_, false, band, p, footprint);
  if (lines_.empty())
    back += painted_share() * (line + gloss_ - back);
  else
    back = lines_.over(back, band, p, footprint, touched_stripes(p, footprint), stripes_.all(), marks_);
  return 1.0 - areas_.over(back, true, band, p, footprint);
}

// Returns a brightness that is random at the points of a lattice and smooth in between. In between, the
// standard deviation is on average 26/35 of the value at the points.
double Floor::patch_brightness(Vec2 p) const {
  const double u = p.x * (1.0 / kPatch), v = p.y * (1.0 / kPatch);
  const double column = std::floor(u), row = std::floor(v);
  const double x = u - column, y = v - row;
  const double east = x * x * (3.0 - 2.0 * x), north = y * y * (3.0 - 2.0 * y);
  const auto drawn = [this](double c, double r) {
    return noise_.gauss(static_cast<std::uint64_t>(static_cast<std::int64_t>(c)) << 32 ^
                        static_cast<std::uint32_t>(static_cast<std::int64_t>(r)));
  };
  const double south = drawn(column, row) * (1.0 - east) + drawn(column + 1.0, row) * east;
  const double above = drawn(column, row + 1.0) * (1.0 - east) + drawn(column + 1.0, row + 1.0) * east;
  return std::max(1.0 + variation_ * (35.0 / 26.0) * (south * (1.0 - north) + above * north), 0.0);
}

// Searches ring by ring about the point's cell. Anything outside ring k is at least k cells away.
double Floor::search(Vec2 p, bool painted_only) const {
  const auto cell_of = [this](double x, double most) {
    return static_cast<int>(
        std::floor(std::min(std::max(x * per_cell_, -kFarCells - 1.0), most + kFarCells)));
  };
  const int column = cell_of(p.x, width_), row = cell_of(p.y, height_);
  const double beyond = 0.5 * cell_ - std::min(half_line_, 0.45 * cell_);
  double best = kNoReach;
  for (int ring = 0; ring <= kFarCells; ++ring) {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, height_ - 1); ++r) {
      const bool whole = r == row - ring || r == row + ring;
      for (int c = column - ring; c <= column + ring; c += whole || ring == 0 ? 1 : 2 * ring) {
        for (const std::uint32_t i : stripes_of(c, r)) {
          const map::Stripe& stripe = stripes_.all()[i];
          if (!stripe.painted && painted_only) continue;
          best = std::min(best, painted_only && is_square(map_) ? square_distance(stripe, p, cell_, beyond)
                                                                : map::distance(stripe, p));
        }
      }
    }
    if (best <= (ring > 0 ? ring * cell_ : stripes_reach_)) break;
  }
  return best < kNoReach ? best : far_m();
}

// Finds the nearest stripe. The result is valid in the point's cell. If `reach` is smaller than
// stripes_reach_, the result is also valid in a margin of stripes_reach_ - reach around the cell. Stripes
// that the cell does not list are at least stripes_reach_ away from the cell. They are therefore at least
// `reach` away from the margin. A cell at the map's edge has no margin.
double Floor::seek(Vec2 p, bool painted_only, double reach, const FloorProbe& probe) const {
  constexpr double kRounding = 1e-9;  // m
  int column, row;
  if (!locate(p, column, row)) {
    probe.forget();
    return stripes_reach_;
  }
  const bool is_at_edge = column == 0 || row == 0 || column == width_ - 1 || row == height_ - 1;
  const double beyond = reach < stripes_reach_ && !is_at_edge ? std::min(stripes_reach_ - reach, cell_) : 0.0;
  const Vec2 centre = {(column + 0.5) * cell_, (row + 0.5) * cell_};
  const double way = 0.5 * cell_ + beyond - kRounding;
  return probe.seek({stripes_.all(),
                     stripes_of(column, row),
                     {centre - Vec2{way, way}, centre + Vec2{way, way}},
                     painted_only,
                     reach},
                    p);
}

double Floor::sought_line_share(Vec2 p, const FloorProbe& probe) const {
  const double footprint = probe.footprint(), reach = half_line_ + 0.5 * footprint;
  if (map_.raster) return raster_share(p, footprint);
  int column, row;
  if (is_square(map_) && reach <= stripes_reach_ && locate(p, column, row)) {
    const auto near = stripes_of(column, row);
    const bool is_gap = map_.at({column, height_ - 1 - row}) == map::Cell::gap;
    if (std::any_of(near.begin(), near.end(), [&](std::uint32_t i) { return !stripes_.all()[i].painted; }))
      return ramp(is_gap ? search(p, true) : std::min(reach, search(p, true)), reach, footprint);
  }
  return ramp(reach > stripes_reach_ ? search(p, true) : std::min(reach, seek(p, true, reach, probe)), reach,
              footprint);
}

// Returns the numbers of all stripes, of any width, that a footprint at p may touch.
std::span<const std::uint32_t> Floor::touched_stripes(Vec2 p, double footprint) const {
  int column, row;
  if (0.5 * (widest_ + footprint) > stripes_reach_) return all_stripes_;
  return locate(p, column, row) ? stripes_of(column, row) : std::span<const std::uint32_t>();
}

double Floor::wide_line_share(Vec2 p, double footprint) const {
  double most = 0.0;
  for (const std::uint32_t i : touched_stripes(p, footprint)) {
    const map::Stripe& stripe = stripes_.all()[i];
    const double width = widths_[stripe.paint];
    if (stripe.painted)
      most = std::max(most, std::min((0.5 * (width + footprint) - map::distance(stripe, p)) / footprint,
                                     std::min(1.0, width / footprint)));
  }
  return most;
}

double Floor::raster_share(Vec2 p, double footprint) const {
  const auto is_dark = [this](int column, int row) {
    const map::Cell cell = map_.at({column, height_ - 1 - row});
    return cell == map::Cell::line || cell == map::Cell::obstacle;
  };
  const double wide = footprint * per_cell_;
  const double u = p.x * per_cell_ - 0.5 * wide + 1.0, v = p.y * per_cell_ - 0.5 * wide + 1.0;
  if (wide <= 1.0) {
    if (!(u >= 0.0 && v >= 0.0 && u < width_ + 1.0 && v < height_ + 1.0)) return 0.0;
    const int column = static_cast<int>(u), row = static_cast<int>(v);
    const bool south_west = is_dark(column - 1, row - 1), south_east = is_dark(column, row - 1);
    const bool north_west = is_dark(column - 1, row), north_east = is_dark(column, row);
    if (south_west == south_east && north_west == north_east && south_west == north_west)
      return south_west ? 1.0 : 0.0;
    const double east = std::max(u - column + wide - 1.0, 0.0) / wide, west = 1.0 - east;
    const double north = std::max(v - row + wide - 1.0, 0.0) / wide, south = 1.0 - north;
    return south * ((south_west ? west : 0.0) + (south_east ? east : 0.0)) +
           north * ((north_west ? west : 0.0) + (north_east ? east : 0.0));
  }
  // The footprint is wider than a cell: sums its overlaps with dark cells. The map begins at u = v = 1.
  const auto first = [](double low) { return static_cast<int>(std::max(std::floor(low) - 1.0, 0.0)); };
  const auto last = [](double high, double most) {
    return static_cast<int>(std::min(std::ceil(high) - 1.0, most));
  };
  const auto overlap = [wide](double low, int cell) {
    return std::max(std::min(low + wide, cell + 2.0) - std::max(low, cell + 1.0), 0.0);
  };
  double dark = 0.0;
  for (int row = first(v); row < last(v + wide, height_); ++row) {
    for (int column = first(u); column < last(u + wide, width_); ++column) {
      if (is_dark(column, row)) dark += overlap(u, column) * overlap(v, row);
    }
  }
  return dark / (wide * wide);
}

}  // namespace robosim::world
