#include "sim/world/floor.h"

namespace robosim::world {

using map::Cell;

namespace {

bool is_painted(Cell c) { return c == Cell::line || c == Cell::obstacle; }

// Largest footprint, m, for which a floor with round corners looks up only nearby stripes.
constexpr double kUsualFootprint = 0.016;

constexpr double kPatch = 0.010;  // m between the sample points of a floor's brightness

// Numbers of kinds of cells (Floor::Kind). 0 is a cell without a line. Painted cells follow; each of their
// four arms is 0 (none), 1 (whole) or 2 (shortened). Cells in a gap of the line are last; each arm is 0
// (none) or 1 (whole).
constexpr int kFirstPainted = 1, kFirstGap = 82;

}  // namespace

Floor::Floor(const map::Map& map)
    : width_(map.width),
      height_(map.height),
      columns_(map.width),
      rows_(map.height),
      cell_(map.cell_m),
      per_cell_(1.0 / map.cell_m),
      half_line_(0.5 * map.line_m),
      map_(&map),
      light_line_(map.light_line),
      image_(map.image.get()),
      marks_(map),
      areas_(map),
      lines_(map, marks_),
      gloss_(map.gloss),
      alike_(areas_.empty() && lines_.empty() && !image_ && gloss_ == 0.0),
      plain_(alike_ && marks_.empty()),
      marked_(false),
      paints_only_(!lines_.empty() && areas_.empty()),
      kinds_{} {
  double widest = map.line_m;
  for (const map::Paint& paint : map.course.paints) widest = std::max(widest, paint.width);
  if (widest > map.line_m && !map.raster)
    for (const map::Paint& paint : map::paints_of(map)) widths_.push_back(std::max(paint.width, map.line_m));
  if (map.corner_m > 0.0 || !map.course.paths.empty()) {
    stripes_reach_ = 0.5 * widest + 0.5 * kUsualFootprint;
    stripes_ = std::make_unique<map::Stripes>(map, stripes_reach_);
    if (alike_ && !marks_.empty() && !map.raster) index_with_marks(map);
  } else {
    read_stripes(map);
  }
  if (map.raster) read_raster(map);
}

void Floor::index_with_marks(const map::Map& map) {
  with_marks_ = std::make_unique<map::StripeIndex>(map, marks_.after(stripes_->all()),
                                                   std::max(stripes_reach_, marks_.reach()));
  marked_ = true;
}

// Reads stripes cell by cell, like map::Stripes. Next to a gap, shortens painted stripes by half the line's
// width.
void Floor::read_stripes(const map::Map& map) {
  const double whole = 0.5 * cell_;
  const double shortened = whole - std::min(half_line_, 0.45 * cell_);
  const double lengths[] = {0.0, whole, shortened};
  const auto arms = [&](int e, int s, int w, int n) {
    return Arms{-lengths[w], lengths[e], -lengths[s], lengths[n]};
  };
  for (int code = 0; code < 81; ++code) {
    const int e = code % 3, s = code / 3 % 3, w = code / 9 % 3, n = code / 27;
    kinds_[kFirstPainted + code] = {arms(e > 0, s > 0, w > 0, n > 0), arms(e, s, w, n), true, true};
  }
  for (int code = 0; code < 16; ++code) {
    kinds_[kFirstGap + code] = {arms(code & 1, code >> 1 & 1, code >> 2 & 1, code >> 3), {}, true, false};
  }
  cells_.resize(map.cells.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const map::CellAt at{x, y};
      const Cell cell = map.at(at);
      if (!map::is_line(cell)) continue;
      int code = 0;
      for (int d = 3; d >= 0; --d) {
        const Cell beside = map.at(map::ahead(at, static_cast<map::Direction>(d)));
        if (is_painted(cell)) {
          code = 3 * code + (beside == Cell::gap ? 2 : map::is_line(beside));
        } else {
          code = 2 * code + map::is_line(beside);
        }
      }
      const int kind = (is_painted(cell) ? kFirstPainted : kFirstGap) + code;
      cells_[index(x, height_ - 1 - y)] = static_cast<std::uint8_t>(kind);
    }
  }
}

void Floor::read_raster(const map::Map& map) {
  quads_.assign((static_cast<std::size_t>(width_) + 1) * (static_cast<std::size_t>(height_) + 1), 0);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!is_painted(map.at({x, y}))) continue;
      const std::size_t stride = static_cast<std::size_t>(width_) + 1;
      std::uint8_t* low =
          &quads_[static_cast<std::size_t>(height_ - 1 - y) * stride + static_cast<std::size_t>(x)];
      low[0] |= 8;
      low[1] |= 4;
      low[stride] |= 2;
      low[stride + 1] |= 1;
    }
  }
}

double Floor::painted_darkness(double x, double y, double footprint_m) const {
  if (!marked_ || footprint_m > kUsualFootprint) return other_darkness(x, y, footprint_m);
  const Vec2 p{x, y};
  const double bare = light_line_ ? 1.0 : 0.0;
  int column, row;
  double east, north;
  if (!locate(p, column, row, east, north)) return bare;
  const auto near = with_marks_->near({column, height_ - 1 - row});
  if (near.empty()) return bare;
  const double footprint = std::max(footprint_m, 1e-9), reach = half_line_ + 0.5 * footprint;
  const std::span<const map::Stripe> lines = stripes_->all();
  double nearest = reach, on_mark = 0.0;
  for (const std::uint32_t i : near) {
    if (i >= lines.size())
      on_mark = std::max(on_mark, marks_.share(i - lines.size(), p, footprint));
    else if (lines[i].painted)
      nearest = std::min(nearest, map::distance(lines[i], p));
  }
  const double painted = std::max(ramp(nearest, reach, footprint), on_mark);
  return light_line_ ? 1.0 - painted : painted;
}

[[gnu::noinline]] double Floor::other_darkness(double x, double y, double footprint_m) const {
  const Vec2 p{x, y};
  return patched(drawn_darkness(p, footprint_m), p, footprint_m);
}

double Floor::darkness_of_paint(Vec2 p, double footprint) const {
  if (image_ && areas_.empty() && gloss_ == 0.0) return image_->darkness(p, std::max(footprint, 1e-6));
  return drawn_darkness(p, footprint, Band::infrared);
}

double Floor::drawn_darkness(Vec2 p, double footprint_m, Band band) const {
  if (alike_) return drawn_darkness(p, footprint_m);
  if (image_ && areas_.empty() && gloss_ == 0.0) return darkness_of_paint(p, footprint_m);
  const double footprint = std::max(footprint_m, image_ ? 1e-6 : 1e-9);
  if (image_) {
    const double bare = 1.0 - image_->darkness(p, footprint) + gloss_;
    const double under = areas_.over(bare, false, band, p, footprint);
    return 1.0 - areas_.over(under, true, band, p, footprint);
  }
  const double line = light_line_ ? 1.0 : 0.0;
  double back = areas_.over(1.0 - line + gloss_, false, band, p, footprint);
  if (lines_.empty())
    back += painted_share(p, footprint_m) * (line + gloss_ - back);
  else
    back = lines_.over(back, band, p, footprint, marks_);
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

double Floor::square_in(int column, int row, Vec2 p, bool painted_only) const {
  double best = std::numeric_limits<double>::infinity();
  if (stripes_) {
    for (const std::uint32_t i : stripes_->near({column, height_ - 1 - row})) {
      const map::Stripe& stripe = stripes_->all()[i];
      if (painted_only && !stripe.painted) continue;
      const double away = map::distance(stripe, p);
      best = std::min(best, away * away);
    }
    return best;
  }
  const Kind& kind = kinds_[cells_[index(column, row)]];
  if (!(painted_only ? kind.is_painted : kind.is_line)) return best;
  const Arms& arms = painted_only ? kind.painted : kind.line;
  return arms.square(p.x - (column + 0.5) * cell_, p.y - (row + 0.5) * cell_);
}

// Searches ring by ring about the point's cell. Anything outside ring k is at least k cells away.
double Floor::search(Vec2 p, bool painted_only) const {
  const auto cell_of = [this](double x, double most) {
    return static_cast<int>(
        std::floor(std::min(std::max(x * per_cell_, -kFarCells - 1.0), most + kFarCells)));
  };
  const int column = cell_of(p.x, columns_), row = cell_of(p.y, rows_);
  double best = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring <= kFarCells; ++ring) {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, height_ - 1); ++r) {
      const bool whole = r == row - ring || r == row + ring;
      for (int c = column - ring; c <= column + ring; c += whole || ring == 0 ? 1 : 2 * ring) {
        if (c >= 0 && c < width_) best = std::min(best, square_in(c, r, p, painted_only));
      }
    }
    const double sure = ring > 0 ? ring * cell_ : stripes_ ? stripes_reach_ : 0.5 * cell_;
    if (best <= sure * sure) break;
  }
  return std::isfinite(best) ? std::sqrt(best) : far_m();
}

double Floor::coverage_round(Vec2 p, double footprint) const {
  int column, row;
  double x, y;
  if (!locate(p, column, row, x, y)) return 0.0;
  const auto near = stripes_->near({column, height_ - 1 - row});
  if (near.empty()) return 0.0;
  const double reach = half_line_ + 0.5 * footprint;
  double nearest = reach;
  for (const std::uint32_t i : near) {
    const map::Stripe& stripe = stripes_->all()[i];
    if (stripe.painted) nearest = std::min(nearest, map::distance(stripe, p));
  }
  return ramp(nearest, reach, footprint);
}

// Finds the nearest stripe. The result is valid in the point's cell. If `reach` is smaller than
// stripes_reach_, the result is also valid in a margin of stripes_reach_ - reach around the cell. Stripes
// that the cell does not list are at least stripes_reach_ away from the cell. They are therefore at least
// `reach` away from the margin. A cell at the map's edge has no margin.
double Floor::seek(Vec2 p, bool painted_only, double reach, NearStripe& found) const {
  constexpr double kRounding = 1e-9;  // m
  found = {};
  int column, row;
  double x, y;
  if (!locate(p, column, row, x, y)) return stripes_reach_;
  const bool is_at_edge = column == 0 || row == 0 || column == width_ - 1 || row == height_ - 1;
  const double beyond = reach < stripes_reach_ && !is_at_edge ? std::min(stripes_reach_ - reach, cell_) : 0.0;
  const Vec2 centre = {(column + 0.5) * cell_, (row + 0.5) * cell_};
  const double way = 0.5 * cell_ + beyond - kRounding;
  return found.seek({stripes_->all(),
                     stripes_->near({column, height_ - 1 - row}),
                     {centre - Vec2{way, way}, centre + Vec2{way, way}},
                     painted_only,
                     reach},
                    p);
}

double Floor::sought_coverage(Vec2 p, double footprint_m, NearStripe& found) const {
  const double footprint = std::max(footprint_m, 1e-9), reach = half_line_ + 0.5 * footprint;
  if (reach > stripes_reach_) return drawn_coverage(p, footprint_m);
  return ramp(std::min(reach, seek(p, true, reach, found)), reach, footprint);
}

double Floor::sought_distance(Vec2 p, NearStripe& found) const {
  if (!stripes_) return distance_to_line(p);
  const double nearest = seek(p, false, std::numeric_limits<double>::infinity(), found);
  return nearest < stripes_reach_ ? std::sqrt(nearest * nearest) : search(p, false);
}

double Floor::on_wide_line(Vec2 p, double footprint) const {
  double most = 0.0;
  const auto look = [&](const map::Stripe& stripe) {
    if (!stripe.painted) return;
    const double width = widths_[stripe.paint];
    most = std::max(most, std::min((0.5 * (width + footprint) - map::distance(stripe, p)) / footprint,
                                   std::min(1.0, width / footprint)));
  };
  int column, row;
  double x, y;
  if (footprint > kUsualFootprint) {
    for (const map::Stripe& stripe : stripes_->all()) look(stripe);
  } else if (locate(p, column, row, x, y)) {
    for (const std::uint32_t i : stripes_->near({column, height_ - 1 - row})) look(stripes_->all()[i]);
  }
  return most;
}

double Floor::coverage_raster(Vec2 p, double footprint) const {
  const double wide = footprint * per_cell_;
  const double u = p.x * per_cell_ - 0.5 * wide + 1.0, v = p.y * per_cell_ - 0.5 * wide + 1.0;
  if (wide <= 1.0) {
    if (!(u >= 0.0 && v >= 0.0 && u < columns_ + 1.0 && v < rows_ + 1.0)) return 0.0;
    const int column = static_cast<int>(u), row = static_cast<int>(v);
    const unsigned quad = quads_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                                 static_cast<std::size_t>(column)];
    if (quad == 0 || quad == 15) return quad ? 1.0 : 0.0;
    const double east = std::max(u - column + wide - 1.0, 0.0) / wide, west = 1.0 - east;
    const double north = std::max(v - row + wide - 1.0, 0.0) / wide, south = 1.0 - north;
    return south * ((quad & 1 ? west : 0.0) + (quad & 2 ? east : 0.0)) +
           north * ((quad & 4 ? west : 0.0) + (quad & 8 ? east : 0.0));
  }
  // The footprint is wider than a cell: sums its overlaps with all cells. The map begins at u = v = 1.
  const auto first = [](double low) { return static_cast<int>(std::max(std::floor(low) - 1.0, 0.0)); };
  const auto last = [](double high, double most) {
    return static_cast<int>(std::min(std::ceil(high) - 1.0, most));
  };
  const auto overlap = [wide](double low, int cell) {
    return std::max(std::min(low + wide, cell + 2.0) - std::max(low, cell + 1.0), 0.0);
  };
  double dark = 0.0;
  for (int row = first(v); row < last(v + wide, rows_); ++row) {
    for (int column = first(u); column < last(u + wide, columns_); ++column) {
      if (is_painted(map_->at({column, height_ - 1 - row}))) dark += overlap(u, column) * overlap(v, row);
    }
  }
  return dark / (wide * wide);
}

}  // namespace robosim::world
