// Stores the stripes near each cell of a map. Cells without stripes use almost no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/map/map.h"

namespace robosim::map {

struct Stripe;

class StripeIndex {
 public:
  StripeIndex() = default;
  /// Builds the index. Throws InputError beyond 2^32 entries.
  StripeIndex(const Map& map, std::span<const Stripe> stripes, double reach_m);

  /// Returns the indices of all stripes within reach of any point of the cell, ascending; empty outside the
  /// map.
  std::span<const std::uint32_t> near(CellAt c) const {
    if (c.x < 0 || c.y < 0 || c.x >= width_ || c.y >= height_) return {};
    const std::uint32_t block = blocks_[block_of(c)];
    if (block == kEmpty) return {};
    const std::size_t i = slot_of(block, c);
    return {entries_.data() + first_[i], first_[i + 1] - first_[i]};
  }

 private:
  // Cells are grouped in blocks of 16 x 16; only blocks with entries have slots.
  static constexpr int kShift = 4;
  static constexpr int kSide = 1 << kShift;
  static constexpr std::uint32_t kEmpty = 0xFFFFFFFF;

  std::size_t block_of(CellAt c) const {
    return static_cast<std::size_t>(c.y >> kShift) * block_columns_ + static_cast<std::size_t>(c.x >> kShift);
  }
  static std::size_t slot_of(std::uint32_t block, CellAt c) {
    const int inside = ((c.y & (kSide - 1)) << kShift) | (c.x & (kSide - 1));
    return static_cast<std::size_t>(block) * (kSide * kSide) + static_cast<std::size_t>(inside);
  }

  int width_ = 0;
  int height_ = 0;
  std::size_t block_columns_ = 0;
  std::vector<std::uint32_t> blocks_;  // per block: its group of slots, or kEmpty
  std::vector<std::uint32_t> first_;  // per slot: beginning of its entries; at the end, the number of entries
  std::vector<std::uint32_t> entries_;
};

}  // namespace robosim::map
