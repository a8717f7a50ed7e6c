#include "sim/map/cells/cell_floor.h"

namespace robosim::cells {

using map::Cell;
using map::CellAt;
using map::Direction;

const char* name_of(Sense sense) {
  static constexpr const char* kNames[] = {"no_path", "straight", "right_turn", "left_turn", "junction"};
  return kNames[static_cast<int>(sense)];
}

CellFloor::CellFloor(const map::Map& map)
    : map_(map),
      columns_(static_cast<std::uint32_t>(map.width) + 2),
      step_{1, static_cast<std::ptrdiff_t>(columns_), -1, -static_cast<std::ptrdiff_t>(columns_)},
      cells_(columns_ * (static_cast<std::size_t>(map.height) + 2), kShut) {
  std::vector<std::uint8_t> bits(static_cast<std::size_t>(map.width));
  for (int y = 0; y < map.height; ++y) {
    pack_own(y);
    if (y > 0) pack_neighbours(y - 1, bits.data());
  }
  pack_neighbours(map.height - 1, bits.data());
}

// The loops below are simple, so that the compiler can vectorise them. A map with a million stations has 55
// million cells.
void CellFloor::pack_own(int y) {
  const auto* row = reinterpret_cast<const std::uint8_t*>(map_.cells.data() + map_.index_of({0, y}));
  std::uint8_t* own = cells_.data() + index_of({0, y});
  const auto width = static_cast<std::size_t>(map_.width);
  static_assert(sizeof(Cell) == 1);
  std::uint8_t obstacles = 0;
  for (std::size_t x = 0; x < width; ++x) {
    const std::uint8_t cell = row[x];
    const std::uint8_t open = cell == static_cast<std::uint8_t>(Cell::line) ? kOpen : 0;
    const std::uint8_t gap = cell == static_cast<std::uint8_t>(Cell::gap) ? kOpen : 0;
    const std::uint8_t wall = cell == static_cast<std::uint8_t>(Cell::wall) ? kWall : 0;
    const std::uint8_t obstacle = cell == static_cast<std::uint8_t>(Cell::obstacle) ? kShut : 0;
    own[x] = static_cast<std::uint8_t>((own[x] & kNearObstacle) | open | gap | wall | obstacle);
    obstacles |= obstacle;
  }
  if (obstacles == 0) return;
  for (std::size_t x = 0; x < width; ++x) {
    if ((own[x] & kShut) == 0) continue;
    for (const std::ptrdiff_t step : step_) own[static_cast<std::ptrdiff_t>(x) + step] |= kNearObstacle;
  }
}

void CellFloor::pack_neighbours(int y, std::uint8_t* bits) {
  std::uint8_t* own = cells_.data() + index_of({0, y});
  const auto width = static_cast<std::size_t>(map_.width);
  const std::uint8_t *east = own + step_[0], *south = own + step_[1];
  const std::uint8_t *west = own + step_[2], *north = own + step_[3];
  static_assert(kOpen == 1u << 4, "the shifts below move this bit to the bits of the directions");
  for (std::size_t x = 0; x < width; ++x) {
    bits[x] = static_cast<std::uint8_t>((east[x] >> 4 & 1) | (south[x] >> 3 & 2) | (west[x] >> 2 & 4) |
                                        (north[x] >> 1 & 8));
  }
  for (std::size_t x = 0; x < width; ++x) own[x] = static_cast<std::uint8_t>(own[x] | bits[x]);
}

Sense CellFloor::sense_alone(std::size_t index, Direction d) const {
  const std::size_t front = next(index, d);
  if (is_open(front)) return Sense::straight;
  // In Robosim v1, the robot continues forever at the map's edge. Here, a line ends at the edge.
  if ((cells_[front] & kWall) == 0) return Sense::no_path;
  return is_open(index) && map::blocks_line(map_, cell_at(index), d) ? Sense::no_path : Sense::straight;
}

Sense CellFloor::sense_without(std::size_t index, Direction d, unsigned cell) const {
  constexpr unsigned kOwn = 2;
  const unsigned side = 1u << ((static_cast<unsigned>(d) + cell) & 3);
  const SenseTable::Entry entry = kSenseTable.of(cells_[index] & ~(cell == kOwn ? kOpen : side), d);
  if (entry != SenseTable::kAlone) return static_cast<Sense>(entry);
  return cell == 0 ? Sense::no_path : sense_alone(index, d);
}

}  // namespace robosim::cells
