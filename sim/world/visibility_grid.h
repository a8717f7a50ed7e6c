// Divides the floor into squares, and stores for each square the objects that may be visible from there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/map/map.h"

namespace robosim::world {

class VisibilityGrid {
 public:
  /// Makes square tiles of `side` (m), or larger tiles if more than 256 would lie along a side of the floor.
  VisibilityGrid(const map::Map& map, double side) {
    constexpr double kMost = 256.0;
    const double wide = map.width * map.cell_m, high = map.height * map.cell_m;
    const double tile = std::max(side, std::max(wide, high) / kMost);
    per_tile_ = 1.0 / tile;
    last_column_ = std::ceil(wide / tile) - 1.0;
    last_row_ = std::ceil(high / tile) - 1.0;
    columns_ = static_cast<int>(last_column_) + 1;
  }

  /// Adds an object that is visible up to `reach` (m) from its middle. Add numbers in ascending order.
  void add(std::uint32_t number, Vec2 middle, double reach) {
    numbers_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(last_row_ + 1.0));
    const int low = place(middle.y - reach, last_row_), high = place(middle.y + reach, last_row_);
    const int left = place(middle.x - reach, last_column_), right = place(middle.x + reach, last_column_);
    for (int row = low; row <= high; ++row)
      for (int column = left; column <= right; ++column)
        numbers_[static_cast<std::size_t>(row * columns_ + column)].push_back(number);
  }

  /// Returns the numbers of objects that may be visible from p. Beyond the floor's edge, uses the nearest
  /// point of the edge.
  std::span<const std::uint32_t> at(Vec2 p) const {
    if (numbers_.empty()) return {};
    return numbers_[static_cast<std::size_t>(place(p.y, last_row_) * columns_ + place(p.x, last_column_))];
  }

 private:
  int place(double metres, double last) const {
    return static_cast<int>(std::min(std::max(metres * per_tile_, 0.0), last));
  }

  double per_tile_, last_column_, last_row_;
  int columns_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // row by row from the bottom
};

}  // namespace robosim::world
