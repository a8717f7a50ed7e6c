#include "sim/world/painted_areas.h"

#include <algorithm>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kWidest = 0.1;  // m; the widest supported footprint
constexpr double kTile = 0.15;   // m

double share_within(double away, double half, double footprint) {
  const double from = std::max(away - 0.5 * footprint, -half);
  const double to = std::min(away + 0.5 * footprint, half);
  return std::max(to - from, 0.0) / footprint;
}

double share_of_area(const map::Area& area, Vec2 p, double footprint) {
  const Vec2 own = area.middle.to_body(p);
  if (area.radius > 0.0)
    return std::clamp((area.radius + 0.5 * footprint - length(own)) / footprint, 0.0,
                      std::min(1.0, 2.0 * area.radius / footprint));
  return share_within(own.x, area.half_length, footprint) * share_within(own.y, area.half_width, footprint);
}

}  // namespace

PaintedAreas::PaintedAreas(const map::Map& map) : areas_(map::visible_areas(map.course)), near_(map, kTile) {
  for (std::size_t i = 0; i < areas_.size(); ++i)
    near_.add(static_cast<std::uint32_t>(i), areas_[i].middle.position, areas_[i].reach() + kWidest);
}

double PaintedAreas::over_any(double below, bool over_lines, Band band, Vec2 p, double footprint) const {
  for (const std::uint32_t i : near_.at(p)) {
    const map::Area& area = areas_[i];
    if (area.over_lines != over_lines) continue;
    const double share = share_of_area(area, p, footprint);
    if (share > 0.0) below += share * (sent_back(area.colour, band) + area.gloss - below);
  }
  return below;
}

}  // namespace robosim::world
