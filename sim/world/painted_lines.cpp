#include "sim/world/painted_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace robosim::world {
namespace {

constexpr double kLookedUpFootprint = 0.016;  // m; larger ones look at all stripes
constexpr double kFlake = 0.010;              // m between the points at which paint is whole or gone
static_assert(grid::Paint::kMost + 1 < 64);   // paints are bits of a word

}  // namespace

PaintedLines::PaintedLines(const grid::Map& map) : map_(&map), paints_(grid::paints_of(map)) {
  if ((map.course.paints.empty() && map.worn == 0.0) || map.image || map.raster) return;
  for (const grid::Paint& paint : paints_)
    reach_ = std::max(reach_, 0.5 * (paint.width + kLookedUpFootprint));
  stripes_ = std::make_unique<grid::Stripes>(map, reach_);
}

double PaintedLines::over(double below, Band band, Vec2 p, double footprint,
                          const PaintedMarks& marks) const {
  std::array<double, grid::Paint::kMost + 1> shares;  // of the paints in `met`; distances at first
  std::uint64_t met = 0;
  const auto approach = [&](const grid::Stripe& stripe) {
    if (!stripe.painted) return;
    const double away = grid::distance(stripe, p);
    const std::uint64_t bit = std::uint64_t{1} << stripe.paint;
    shares[stripe.paint] = met & bit ? std::min(shares[stripe.paint], away) : away;
    met |= bit;
  };
  if (footprint <= kLookedUpFootprint) {
    const double u = p.x / map_->cell_m, v = p.y / map_->cell_m;
    if (!(u >= 0.0 && v >= 0.0 && u < map_->width && v < map_->height)) return below;
    for (const std::uint32_t i :
         stripes_->near({static_cast<int>(u), map_->height - 1 - static_cast<int>(v)}))
      approach(stripes_->all()[i]);
  } else {
    for (const grid::Stripe& stripe : stripes_->all()) approach(stripe);
  }
  for (std::uint64_t rest = met; rest; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const double width = paints_[i].width;
    shares[i] = std::clamp((0.5 * (width + footprint) - shares[i]) / footprint, 0.0,
                           std::min(1.0, width / footprint));
  }
  if (!marks.empty()) {
    for (std::size_t i = 0; i < paints_.size(); ++i)
      if (!(met >> i & 1)) shares[i] = 0.0;
    met = (std::uint64_t{1} << paints_.size()) - 1;
    marks.raise(p, footprint, {shares.data(), paints_.size()});
  }
  for (std::uint64_t rest = met; rest; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const grid::Paint& paint = paints_[i];
    if (shares[i] <= 0.0) continue;
    const double there = paint.worn > 0.0 ? shares[i] * left(p, paint.worn) : shares[i];
    below += there * (sent_back(*paint.colour, band) + paint.gloss - below);
  }
  return below;
}

double PaintedLines::left(Vec2 p, double worn) const {
  const double u = p.x * (1.0 / kFlake), v = p.y * (1.0 / kFlake);
  const double column = std::floor(u), row = std::floor(v);
  const double x = u - column, y = v - row;
  const double east = x * x * (3.0 - 2.0 * x), north = y * y * (3.0 - 2.0 * y);
  const auto whole = [&](double c, double r) {
    const auto point = static_cast<std::uint64_t>(static_cast<std::int64_t>(c)) << 32 ^
                       static_cast<std::uint32_t>(static_cast<std::int64_t>(r));
    return noise_.uniform(point) >= worn ? 1.0 : 0.0;
  };
  const double south = whole(column, row) * (1.0 - east) + whole(column + 1.0, row) * east;
  const double above = whole(column, row + 1.0) * (1.0 - east) + whole(column + 1.0, row + 1.0) * east;
  return south * (1.0 - north) + above * north;
}

}  // namespace robosim::world
