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
    const double corner = std::sqrt(mark.half_length * mark.half_length + mark.half_width * mark.half_width);
    near_.add(static_cast<std::uint32_t>(i), mark.middle.position, corner + kLookedUpFootprint * kDiagonal);
  }
}

double PaintedMarks::coverage(Vec2 p, double footprint) const {
  double most = 0.0;
  visit_near(p, footprint, [&](std::size_t i) { most = std::max(most, share(i, p, footprint)); });
  return most;
}

}  // namespace robosim::world
