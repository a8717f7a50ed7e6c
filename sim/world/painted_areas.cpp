#include "sim/world/painted_areas.h"

#include <algorithm>
#include <cmath>

namespace robosim::world {
namespace {

constexpr double kWidest = 0.1;                         // m; the widest footprint that is looked up
constexpr double kLeastTile = 0.15, kMostTiles = 64.0;  // m; to a side of the floor

double share_within(double away, double half, double footprint) {
  const double from = std::max(away - 0.5 * footprint, -half);
  const double to = std::min(away + 0.5 * footprint, half);
  return std::max(to - from, 0.0) / footprint;
}

double share_of_area(const grid::Area& area, Vec2 p, double footprint) {
  const Vec2 own = area.middle.to_body(p);
  if (area.radius > 0.0)
    return std::clamp((area.radius + 0.5 * footprint - length(own)) / footprint, 0.0,
                      std::min(1.0, 2.0 * area.radius / footprint));
  return share_within(own.x, area.half_length, footprint) * share_within(own.y, area.half_width, footprint);
}

}  // namespace

PaintedAreas::PaintedAreas(const grid::Map& map) : areas_(map.course.areas) {
  if (areas_.empty()) return;
  const double wide = map.width * map.cell_m, high = map.height * map.cell_m;
  tile_ = std::max(kLeastTile, std::max(wide, high) / kMostTiles);
  columns_ = static_cast<int>(std::ceil(wide / tile_));
  rows_ = static_cast<int>(std::ceil(high / tile_));
  near_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const Vec2 middle = areas_[i].middle.position;
    const double reach = areas_[i].reach() + kWidest;
    for (int row = tile_of(middle.y - reach, rows_); row <= tile_of(middle.y + reach, rows_); ++row)
      for (int column = tile_of(middle.x - reach, columns_); column <= tile_of(middle.x + reach, columns_);
           ++column)
        near_[static_cast<std::size_t>(row * columns_ + column)].push_back(static_cast<std::uint32_t>(i));
  }
}

int PaintedAreas::tile_of(double metres, int count) const {
  return static_cast<int>(std::clamp(std::floor(metres / tile_), 0.0, count - 1.0));
}

double PaintedAreas::over(double below, bool over_lines, Band band, Vec2 p, double footprint) const {
  if (areas_.empty()) return below;
  const int tile = tile_of(p.y, rows_) * columns_ + tile_of(p.x, columns_);
  for (const std::uint32_t i : near_[static_cast<std::size_t>(tile)]) {
    const grid::Area& area = areas_[i];
    if (area.over_lines != over_lines) continue;
    const double share = share_of_area(area, p, footprint);
    if (share > 0.0) below += share * (sent_back(area.colour, band) + area.gloss - below);
  }
  return below;
}

}  // namespace robosim::world
