#include "sim/world/painted_marks.h"

#include <algorithm>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kWidestLooked = 0.1;  // m; the widest footprint that is looked up
constexpr double kDiagonal = 0.708;    // of a square, the half of it

double share_of(double away, double half, double footprint) {
  const double from = std::max(away - 0.5 * footprint, -half);
  const double to = std::min(away + 0.5 * footprint, half);
  return std::max(to - from, 0.0) / footprint;
}

}  // namespace

PaintedMarks::PaintedMarks(const grid::Map& map)
    : wide_(map.width * map.cell_m),
      high_(map.height * map.cell_m),
      marks_(map.course.marks),
      near_(map, kTile) {
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const grid::Mark& mark = marks_[i];
    reaches_.push_back(std::sqrt(mark.half_length * mark.half_length + mark.half_width * mark.half_width));
    near_.add(static_cast<std::uint32_t>(i), mark.middle.position,
              reaches_[i] + kLookedUpFootprint * kDiagonal);
  }
}

template <class Visit>
void PaintedMarks::visit_near(Vec2 p, double footprint, Visit visit) const {
  if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < wide_ && p.y < high_)) return;
  const auto look = [&](std::size_t i) {
    const grid::Mark& mark = marks_[i];
    const Vec2 away = p - mark.middle.position;
    const double reach = reaches_[i] + footprint * kDiagonal;
    if (dot(away, away) > reach * reach) return;
    const Vec2 own = mark.middle.to_body(p);
    visit(mark, share_of(own.x, mark.half_length, footprint) * share_of(own.y, mark.half_width, footprint));
  };
  if (footprint > kLookedUpFootprint) {
    for (std::size_t i = 0; i < marks_.size(); ++i) look(i);
  } else {
    for (const std::uint32_t i : near_.at(p)) look(i);
  }
}

double PaintedMarks::coverage(Vec2 p, double footprint) const {
  double most = 0.0;
  visit_near(p, footprint, [&](const grid::Mark&, double share) { most = std::max(most, share); });
  return most;
}

void PaintedMarks::raise(Vec2 p, double footprint, double* most, std::uint64_t& met) const {
  visit_near(p, footprint, [&](const grid::Mark& mark, double share) {
    double& of_paint = most[mark.paint];
    const std::uint64_t bit = std::uint64_t{1} << mark.paint;
    of_paint = std::max(met & bit ? of_paint : 0.0, share);
    met |= bit;
  });
}

}  // namespace robosim::world
