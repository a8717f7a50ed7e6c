#include "sim/world/painted_marks.h"

#include <algorithm>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kMarksTile = 0.15;  // m
constexpr double kDiagonal = 0.708;  // half the diagonal of a unit square

}  // namespace

PaintedMarks::PaintedMarks(const map::Map& map)
    : wide_(map.width * map.cell_m),
      high_(map.height * map.cell_m),
      marks_(map.course.marks),
      near_(map, kMarksTile) {
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const map::Mark& mark = marks_[i];
    reaches_.push_back(std::sqrt(mark.half_length * mark.half_length + mark.half_width * mark.half_width));
    near_.add(static_cast<std::uint32_t>(i), mark.middle.position,
              reaches_[i] + kLookedUpFootprint * kDiagonal);
    reach_ = std::max(reach_, mark.half_width + kLookedUpFootprint * kDiagonal);
  }
}

std::vector<map::Stripe> PaintedMarks::after(std::span<const map::Stripe> lines) const {
  std::vector<map::Stripe> all(lines.begin(), lines.end());
  for (const map::Mark& mark : marks_) {
    const Vec2 half = mark.middle.heading * mark.half_length;
    all.push_back({mark.middle.position - half, mark.middle.position + half, {}});
  }
  return all;
}

double PaintedMarks::coverage(Vec2 p, double footprint) const {
  if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < wide_ && p.y < high_)) return 0.0;
  double most = 0.0;
  const auto look = [&](std::size_t i) {
    const Vec2 away = p - marks_[i].middle.position;
    const double reach = reaches_[i] + footprint * kDiagonal;
    if (dot(away, away) <= reach * reach) most = std::max(most, share(i, p, footprint));
  };
  if (footprint > kLookedUpFootprint) {
    for (std::size_t i = 0; i < marks_.size(); ++i) look(i);
  } else {
    for (const std::uint32_t i : near_.at(p)) look(i);
  }
  return most;
}

}  // namespace robosim::world
