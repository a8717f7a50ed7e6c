// Finds the junction at a cell of a map. The map is divided into tiles of 64 x 64 cells; only tiles with
// junctions are stored.
//
// A bit of the tile shows whether the cell has a junction; almost always, it has none. If it has one, the
// tile's junctions are searched, in the order in which they were added.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "firmware/src/nav/Landmark.h"

namespace robosim::cells {

class JunctionIndex {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xFFFFFFFF;

  /// Returns the junction at `place`, or kNone if the cell has no junction. Here and in add(), coordinates
  /// must not be negative.
  Id find(const nav::Place& place) const {
    const Tile* tile = tile_at(place);
    if (!tile || (tile->row(place) >> column(place) & 1) == 0) return kNone;
    const auto found = std::find(tile->cells.begin(), tile->cells.end(), cell(place));
    return tile->ids[static_cast<std::size_t>(found - tile->cells.begin())];
  }
  /// Adds a junction at a place that has none.
  void add(const nav::Place& place, Id id);
  void clear() { tiles_.clear(); }

 private:
  static constexpr unsigned kSideBits = 6;
  static constexpr std::uint32_t kSide = 1u << kSideBits;

  struct Tile {
    std::array<std::uint64_t, kSide> rows{};  ///< one bit per cell
    std::vector<std::uint16_t> cells;         ///< cells of the junctions
    std::vector<Id> ids;                      ///< numbers of the junctions
    std::uint64_t row(const nav::Place& place) const {
      return rows[static_cast<std::uint32_t>(place.y) % kSide];
    }
  };

  static std::uint32_t column(const nav::Place& place) { return static_cast<std::uint32_t>(place.x) % kSide; }
  static std::uint16_t cell(const nav::Place& place) {
    return static_cast<std::uint16_t>(static_cast<std::uint32_t>(place.y) % kSide * kSide + column(place));
  }
  const Tile* tile_at(const nav::Place& place) const {
    const std::size_t y = static_cast<std::uint32_t>(place.y) >> kSideBits;
    const std::size_t x = static_cast<std::uint32_t>(place.x) >> kSideBits;
    return y < tiles_.size() && x < tiles_[y].size() ? tiles_[y][x].get() : nullptr;
  }

  std::vector<std::vector<std::unique_ptr<Tile>>> tiles_;  ///< by row and column
};

}  // namespace robosim::cells
