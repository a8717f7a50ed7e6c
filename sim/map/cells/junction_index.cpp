#include "sim/map/cells/junction_index.h"

namespace robosim::cells {

void JunctionIndex::add(const nav::Place& place, Id id) {
  const std::size_t y = static_cast<std::uint32_t>(place.y) >> kSideBits;
  const std::size_t x = static_cast<std::uint32_t>(place.x) >> kSideBits;
  if (y >= tiles_.size()) tiles_.resize(y + 1);
  if (x >= tiles_[y].size()) tiles_[y].resize(x + 1);
  std::unique_ptr<Tile>& tile = tiles_[y][x];
  if (!tile) tile = std::make_unique<Tile>();
  tile->rows[static_cast<std::uint32_t>(place.y) % kSide] |= std::uint64_t{1} << column(place);
  tile->cells.push_back(cell(place));
  tile->ids.push_back(id);
}

}  // namespace robosim::cells
