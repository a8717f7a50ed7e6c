#include "sim/world/painted_marks.h"

#include <algorithm>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kReach = 0.05;  // m; half of the widest footprint that is looked up

double share_of(double away, double half, double footprint) {
  const double from = std::max(away - 0.5 * footprint, -half);
  const double to = std::min(away + 0.5 * footprint, half);
  return std::max(to - from, 0.0) / footprint;
}

}  // namespace

PaintedMarks::PaintedMarks(const grid::Map& map) : map_(&map), marks_(map.course.marks) {
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const grid::Mark& mark = marks_[i];
    const double reach = std::sqrt(mark.half_length * mark.half_length + mark.half_width * mark.half_width) +
                         kReach * std::sqrt(2.0);
    const int cells = static_cast<int>(std::ceil(reach / map.cell_m));
    const auto column = static_cast<int>(std::floor(mark.middle.position.x / map.cell_m));
    const auto row = map.height - 1 - static_cast<int>(std::floor(mark.middle.position.y / map.cell_m));
    for (int y = std::max(row - cells, 0); y <= std::min(row + cells, map.height - 1); ++y)
      for (int x = std::max(column - cells, 0); x <= std::min(column + cells, map.width - 1); ++x)
        near_.emplace_back(map.index_of({x, y}), static_cast<std::uint32_t>(i));
  }
  std::sort(near_.begin(), near_.end());
}

template <class Visit>
void PaintedMarks::visit_near(Vec2 p, double footprint, Visit visit) const {
  const double u = p.x / map_->cell_m, v = p.y / map_->cell_m;
  if (!(u >= 0.0 && v >= 0.0 && u < map_->width && v < map_->height)) return;
  const std::size_t cell = map_->index_of({static_cast<int>(u), map_->height - 1 - static_cast<int>(v)});
  for (auto it = std::lower_bound(near_.begin(), near_.end(), std::pair{cell, std::uint32_t{0}});
       it != near_.end() && it->first == cell; ++it) {
    const grid::Mark& mark = marks_[it->second];
    const Vec2 own = mark.middle.to_body(p);
    visit(mark, share_of(own.x, mark.half_length, footprint) * share_of(own.y, mark.half_width, footprint));
  }
}

double PaintedMarks::coverage(Vec2 p, double footprint) const {
  double most = 0.0;
  visit_near(p, footprint, [&](const grid::Mark&, double share) { most = std::max(most, share); });
  return most;
}

void PaintedMarks::raise(Vec2 p, double footprint, std::span<double> most) const {
  visit_near(p, footprint, [&](const grid::Mark& mark, double share) {
    double& of_paint = most[static_cast<std::size_t>(mark.paint)];
    of_paint = std::max(of_paint, share);
  });
}

}  // namespace robosim::world
