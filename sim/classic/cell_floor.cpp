#include "sim/classic/cell_floor.h"

namespace robosim::classic {

using grid::Cell;
using grid::CellAt;
using grid::Direction;

const char* name_of(Sense sense) {
  static constexpr const char* kNames[] = {"no_path", "straight", "right_turn", "left_turn", "junction"};
  return kNames[static_cast<int>(sense)];
}

CellFloor::CellFloor(const grid::Map& map)
    : map_(map),
      columns_(static_cast<std::size_t>(map.width) + 2),
      step_{1, static_cast<std::ptrdiff_t>(columns_), -1, -static_cast<std::ptrdiff_t>(columns_)},
      cells_(columns_ * (static_cast<std::size_t>(map.height) + 2), kShut) {
  const auto width = static_cast<std::size_t>(map.width);
  for (int y = 0; y < map.height; ++y) {
    const Cell* row = map.cells.data() + map.index_of({0, y});
    std::uint8_t* own = cells_.data() + index_of({0, y});
    for (std::size_t x = 0; x < width; ++x) {
      const bool open = row[x] == Cell::line || row[x] == Cell::gap;
      own[x] = static_cast<std::uint8_t>((open ? kOpen : 0) | (row[x] == Cell::obstacle ? kShut : 0));
    }
  }
  // Only line has neighbours that count, or obstacles on them: whatever is rare is done where it stands.
  for (int y = 0; y < map.height; ++y) {
    const Cell* row = map.cells.data() + map.index_of({0, y});
    const std::size_t first = index_of({0, y});
    for (std::size_t x = 0; x < width; ++x) {
      if (row[x] == Cell::floor || row[x] == Cell::wall) continue;
      const std::size_t here = first + x;
      for (std::size_t d = 0; d < 4; ++d) {
        std::uint8_t& beside = cells_[here + static_cast<std::size_t>(step_[d])];
        if (row[x] == Cell::obstacle) {
          beside |= kNearObstacle;
        } else {
          beside |= static_cast<std::uint8_t>(1u << ((d + 2) & 3));
        }
      }
    }
  }
}

Sense CellFloor::sense_alone(std::size_t index, Direction d) const {
  const std::size_t front = index + static_cast<std::size_t>(step(d));
  if (is_open(front)) return Sense::straight;
  const CellAt cell = cell_at(front);
  // v1 drives on at the map's edge, for ever; here a line that ends there has a dead end like any other.
  if (!map_.contains(cell) || map_.at(cell) != Cell::wall) return Sense::no_path;
  return is_open(index) && grid::blocks_line(map_, cell_at(index), d) ? Sense::no_path : Sense::straight;
}

Sense CellFloor::sense_without(std::size_t index, Direction d, unsigned cell) const {
  constexpr unsigned kOwn = 2;
  const unsigned side = 1u << ((static_cast<unsigned>(d) + cell) & 3);
  const unsigned bits = cells_[index] & (kOpen | kNeighbours) & ~(cell == kOwn ? kOpen : side);
  const Table::Entry entry = kTable.of[bits * 4u + static_cast<std::size_t>(d)];
  if (entry != Table::kAlone) return static_cast<Sense>(entry);
  return cell == 0 ? Sense::no_path : sense_alone(index, d);
}

}  // namespace robosim::classic
