#include "sim/world/painted_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace robosim::world {
namespace {

constexpr double kFlake = 0.010;            // m between the sample points of worn paint
static_assert(map::Paint::kMost + 1 < 64);  // paints are bits of a word

}  // namespace

PaintedLines::PaintedLines(const map::Map& map, const PaintedMarks& marks)
    : columns_(map.width), rows_(map.height), per_cell_(1.0 / map.cell_m), last_row_(map.height - 1) {
  if ((map.course.paints.empty() && map.worn == 0.0) || map.image || map.raster) return;
  for (const map::Paint& paint : map::paints_of(map)) {
    reach_ = std::max(reach_, 0.5 * (paint.width + kLookedUpFootprint));
    Paint& own = paints_.emplace_back(Paint{paint.width, paint.worn, {}});
    for (const Band band : {Band::infrared, Band::red, Band::green, Band::blue})
      own.back[static_cast<std::size_t>(band)] = sent_back(*paint.colour, band) + paint.gloss;
  }
  stripes_ = std::make_unique<map::Stripes>(map, reach_);
  const std::vector<map::Stripe> lines_and_marks = marks.after(stripes_->all());
  index_ = map::StripeIndex(map, lines_and_marks, std::max(reach_, marks.reach()));
  all_.resize(lines_and_marks.size());
  std::iota(all_.begin(), all_.end(), 0u);
}

double PaintedLines::over_these(std::span<const std::uint32_t> near, double below, Band band, Vec2 p,
                                double footprint, const PaintedMarks& marks) const {
  // For each paint in `met`: the distance to the nearest stripe, later replaced by the covered share.
  std::array<double, map::Paint::kMost + 1> shares;
  std::uint64_t met = 0;
  const std::span<const map::Stripe> lines = stripes_->all();
  auto at = near.begin();
  for (; at != near.end() && *at < lines.size(); ++at) {
    const map::Stripe& stripe = lines[*at];
    if (!stripe.painted) continue;
    const double away = map::distance(stripe, p);
    if (away >= 0.5 * (paints_[stripe.paint].width + footprint)) continue;
    const std::uint64_t bit = std::uint64_t{1} << stripe.paint;
    shares[stripe.paint] = met & bit ? std::min(shares[stripe.paint], away) : away;
    met |= bit;
  }
  const auto each_met = [&](auto visit) {
    for (std::uint64_t rest = met; rest; rest &= rest - 1)
      visit(static_cast<std::size_t>(std::countr_zero(rest)));
  };
  const auto share_of_line = [&](std::size_t i) {
    const double width = paints_[i].width;
    return std::min((0.5 * (width + footprint) - shares[i]) / footprint, std::min(1.0, width / footprint));
  };
  const auto lay = [&](std::size_t i, double share) {
    if (share <= 0.0) return;
    const Paint& paint = paints_[i];
    const double there = paint.worn > 0.0 ? share * left(p, paint.worn) : share;
    below += there * (paint.back[static_cast<std::size_t>(band)] - below);
  };
  if (at == near.end()) {
    each_met([&](std::size_t i) { lay(i, share_of_line(i)); });
  } else {
    each_met([&](std::size_t i) { shares[i] = share_of_line(i); });
    for (; at != near.end(); ++at) {
      const std::size_t mark = *at - lines.size(), paint = marks.paint(mark);
      const std::uint64_t bit = std::uint64_t{1} << paint;
      shares[paint] = std::max(met & bit ? shares[paint] : 0.0, marks.share(mark, p, footprint));
      met |= bit;
    }
    each_met([&](std::size_t i) { lay(i, shares[i]); });
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
