#include "sim/world/painted_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kFlake = 0.010;            // m between the sample points of worn paint
static_assert(map::Paint::kMost + 1 < 64);  // paints are bits of a word

}  // namespace

PaintedLines::PaintedLines(const map::Map& map) {
  if ((map.course.paints.empty() && map.worn == 0.0) || map.image || map.raster) return;
  for (const map::Paint& paint : map::paints_of(map)) {
    Paint& own = paints_.emplace_back(Paint{paint.width, paint.worn, {}});
    for (const Band band : {Band::infrared, Band::red, Band::green, Band::blue})
      own.back[static_cast<std::size_t>(band)] = sent_back(*paint.colour, band) + paint.gloss;
  }
}

double PaintedLines::over(double below, Band band, Vec2 p, double footprint,
                          std::span<const std::uint32_t> near, std::span<const map::Stripe> lines,
                          const PaintedMarks& marks) const {
  std::array<double, map::Paint::kMost + 1> shares;  // of each paint in `met`
  std::uint64_t met = 0;
  const auto meet = [&](std::size_t paint, double share) {
    if (share <= 0.0) return;
    const std::uint64_t bit = std::uint64_t{1} << paint;
    shares[paint] = met & bit ? std::max(shares[paint], share) : share;
    met |= bit;
  };
  for (const std::uint32_t i : near) {
    const double width = paints_[lines[i].paint].width;
    if (lines[i].painted)
      meet(lines[i].paint, std::min((0.5 * (width + footprint) - map::distance(lines[i], p)) / footprint,
                                    std::min(1.0, width / footprint)));
  }
  marks.visit_near(p, footprint, [&](std::size_t i) { meet(marks.paint(i), marks.share(i, p, footprint)); });
  for (std::uint64_t rest = met; rest; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const Paint& paint = paints_[i];
    const double there = paint.worn > 0.0 ? shares[i] * left(p, paint.worn) : shares[i];
    below += there * (paint.back[static_cast<std::size_t>(band)] - below);
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
