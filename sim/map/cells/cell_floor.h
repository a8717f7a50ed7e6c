// Stores a map for a robot that moves from cell to cell, with one byte per cell. Sensing is one look-up in a
// table of 128 entries.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/map/map.h"

namespace robosim::cells {

/// The robot's perception, as in Robosim v1. It depends on which of four cells are line: the cells in front,
/// on the right and on the left, and the robot's own cell.
enum class Sense : std::uint8_t { no_path, straight, right_turn, left_turn, junction };
/// Returns "no_path", "straight", …
const char* name_of(Sense sense);

// Bits of a cell's byte. The low four bits are the directions whose next cell is open line (line without an
// obstacle). The other bits describe the cell itself and its surroundings.
inline constexpr std::uint8_t kNeighbours = 0x0F;
inline constexpr std::uint8_t kOpen = 0x10;
inline constexpr std::uint8_t kNearObstacle = 0x20;
inline constexpr std::uint8_t kShut = 0x40;
inline constexpr std::uint8_t kWall = 0x80;

/// Maps the byte of the robot's cell to the robot's perception.
class SenseTable {
 public:
  using Entry = std::uint8_t;
  static constexpr Entry kAlone = 255;  ///< only one of the four cells is line, so the cell ahead decides

  constexpr SenseTable();
  /// Returns a Sense or kAlone.
  constexpr Entry of(unsigned byte, map::Direction d) const {
    return entries_[(byte & (kOpen | kNeighbours)) * 4u + static_cast<std::size_t>(d)];
  }

 private:
  std::array<Entry, 128> entries_{};
};

constexpr SenseTable::SenseTable() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const unsigned byte = static_cast<unsigned>(i / 4);
    const auto d = static_cast<map::Direction>(i % 4);
    const bool own = (byte & kOpen) != 0;
    const bool front = map::has(byte, d);
    const bool right = map::has(byte, map::turned_right(d));
    const bool left = map::has(byte, map::turned_left(d));
    const int lines = own + front + right + left;
    Sense sense = Sense::straight;
    if (lines >= 3) {
      sense = Sense::junction;
    } else if (lines == 0) {
      sense = Sense::no_path;
    } else if (right && left) {  // the robot's own cell is not line
      const bool vertical = d == map::Direction::north || d == map::Direction::west;
      sense = vertical ? Sense::right_turn : Sense::left_turn;
    } else if (lines == 2 && right) {
      sense = Sense::right_turn;
    } else if (lines == 2 && left) {
      sense = Sense::left_turn;
    }
    entries_[i] = lines == 1 ? kAlone : static_cast<Entry>(sense);
  }
}
inline constexpr SenseTable kSenseTable;

/// A robot's place: the number of its cell, and the robot's direction.
struct Spot {
  std::size_t at = 0;
  map::Direction facing = map::Direction::east;
  bool operator==(const Spot&) const = default;
};

class CellFloor {
 public:
  /// `map` must outlive this object. Construction takes about 1 ns per cell.
  explicit CellFloor(const map::Map& map);

  const map::Map& map() const { return map_; }

  /// Returns a cell's number. Cells are numbered row by row, with a border of one cell around the map.
  std::size_t index_of(map::CellAt c) const {
    return static_cast<std::size_t>(c.y + 1) * columns_ + static_cast<std::size_t>(c.x + 1);
  }
  map::CellAt cell_at(std::size_t index) const {
    const auto i = static_cast<std::uint32_t>(index);  // maps have at most 10^9 cells
    return {static_cast<int>(i % columns_) - 1, static_cast<int>(i / columns_) - 1};
  }
  /// Returns the difference between the numbers of a cell and of its neighbour in a direction.
  std::ptrdiff_t step(map::Direction d) const { return step_[static_cast<std::size_t>(d)]; }
  std::size_t next(std::size_t index, map::Direction d) const {
    return index + static_cast<std::size_t>(step(d));
  }

  /// Returns the byte of a cell.
  std::uint8_t byte(std::size_t index) const { return cells_[index]; }
  /// Returns the bytes of all cells, by number.
  const std::uint8_t* bytes() const { return cells_.data(); }
  /// Returns whether a cell is line without an obstacle.
  bool is_open(std::size_t index) const { return (cells_[index] & kOpen) != 0; }
  /// Returns whether a cell is off the map, or has an obstacle.
  bool is_shut(std::size_t index) const { return (cells_[index] & kShut) != 0; }
  bool is_wall(std::size_t index) const { return (cells_[index] & kWall) != 0; }
  /// Returns the directions in which a cell's neighbour is open line, as bits 1 << Direction.
  unsigned open_neighbours(std::size_t index) const { return cells_[index] & kNeighbours; }
  /// Returns whether a neighbouring cell has an obstacle.
  bool is_near_obstacle(std::size_t index) const { return (cells_[index] & kNearObstacle) != 0; }

  Sense sense(std::size_t index, map::Direction d) const {
    const SenseTable::Entry entry = kSenseTable.of(cells_[index], d);
    return entry != SenseTable::kAlone ? static_cast<Sense>(entry) : sense_alone(index, d);
  }
  /// Returns the robot's perception if the robot misses the line on one of the four cells. `cell` is 0 for
  /// the front, 1 for the right, 2 for the robot's own cell, and 3 for the left.
  Sense sense_without(std::size_t index, map::Direction d, unsigned cell) const;

 private:
  void pack_own(int y);
  void pack_neighbours(int y, std::uint8_t* bits);
  Sense sense_alone(std::size_t index, map::Direction d) const;

  const map::Map& map_;
  std::uint32_t columns_;
  std::array<std::ptrdiff_t, 4> step_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace robosim::cells
