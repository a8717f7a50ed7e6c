#include "sim/map/cells/quick.h"

#include <bit>

namespace robosim::cells {
namespace {

using map::Direction;

// Maps the byte of the robot's cell to the walk's action: a number of quarter turns to the right before a
// move, or kAround, or kAhead. The robot moves only onto open line, so nothing can block it.
class WalkTable {
 public:
  static constexpr std::uint8_t kRight = 1, kLeft = 3;
  static constexpr std::uint8_t kAround = 4;  // the robot turns round in place
  static constexpr std::uint8_t kAhead = 5;   // the cell ahead decides

  constexpr explicit WalkTable(Side side) {
    for (unsigned byte = 0; byte < 32; ++byte)
      for (unsigned d = 0; d < 4; ++d) entries_[byte * 4 + d] = entry(side, byte, static_cast<Direction>(d));
  }
  std::uint8_t of(unsigned byte, unsigned d) const {
    return entries_[(byte & (kOpen | kNeighbours)) * 4 + d];
  }

 private:
  static constexpr std::uint8_t entry(Side side, unsigned byte, Direction d) {
    const SenseTable::Entry sensed = kSenseTable.of(byte, d);
    if (sensed == SenseTable::kAlone) return kAhead;
    switch (static_cast<Sense>(sensed)) {
      case Sense::no_path:
        return kAround;
      case Sense::right_turn:
        return kRight;
      case Sense::left_turn:
        return kLeft;
      case Sense::junction:
        if (side == Side::left) return map::has(byte, turned_left(d)) ? kLeft : 0;
        return map::has(byte, turned_right(d)) ? kRight : 0;
      case Sense::straight:
        break;
    }
    return 0;
  }
  std::uint8_t entries_[128] = {};
};
constexpr WalkTable kKeepsLeft(Side::left), kKeepsRight(Side::right);

// Returns the byte of a straight piece of plain line in direction d. Bends are handled by branches, because a
// processor predicts branches, but would have to wait for a table's entry.
constexpr std::uint8_t straight(unsigned d) {
  return static_cast<std::uint8_t>(kOpen | 1u << d | 1u << (d ^ 2));
}

struct NoStops {
  static bool at_place(std::size_t) { return false; }
  static bool at_spot(std::size_t, unsigned) { return false; }
  static bool at_end(std::uint8_t) { return false; }
};

struct Stops {
  const Spot &a, &b;
  bool at_place(std::size_t at) const { return at == a.at || at == b.at; }
  bool at_spot(std::size_t at, unsigned d) const {
    const Spot spot{at, static_cast<Direction>(d)};
    return spot == a || spot == b;
  }
  static bool at_end(std::uint8_t byte) {
    return (byte & kOpen) != 0 && (byte & (byte - 1) & kNeighbours) == 0;
  }
};

template <class Stops>
std::uint64_t walk(const WalkTable& table, const CellFloor& floor, Spot& spot, std::uint64_t most,
                   const Stops stops) {
  const std::uint8_t* const bytes = floor.bytes();
  std::size_t at = spot.at;
  auto d = static_cast<unsigned>(spot.facing);
  std::uint64_t left = most;
  const auto step = [&] { return static_cast<std::size_t>(floor.step(static_cast<Direction>(d))); };
  while (left > 0) {
    for (const std::size_t ahead = step(); bytes[at] == straight(d);) {
      at += ahead;
      if (--left == 0 || stops.at_place(at)) break;
    }
    if (left == 0 || (left < most && (stops.at_spot(at, d) || stops.at_end(bytes[at])))) break;
    const std::uint8_t turn = table.of(bytes[at], d);
    if (turn == WalkTable::kAhead) {
      const std::uint8_t ahead = bytes[at + step()];
      if ((ahead & kWall) != 0) break;
      if ((ahead & kOpen) != 0) {
        at += step();
      } else {
        d ^= 2;
      }
    } else if (turn == WalkTable::kAround) {
      d ^= 2;
    } else {
      if (turn == WalkTable::kRight) {
        d = (d + 1) & 3;
      } else if (turn == WalkTable::kLeft) {
        d = (d + 3) & 3;
      }
      at += step();
    }
    --left;
    if (stops.at_spot(at, d)) break;
  }
  spot = {at, static_cast<Direction>(d)};
  return most - left;
}

const WalkTable& table_of(Side side) { return side == Side::left ? kKeepsLeft : kKeepsRight; }

}  // namespace

std::uint64_t run_along(const CellFloor& floor, Spot& spot, std::uint64_t most) {
  const std::uint8_t* const bytes = floor.bytes();
  std::size_t at = spot.at;
  auto d = static_cast<unsigned>(spot.facing);
  std::uint64_t left = most;
  while (left > 0) {
    const auto ahead = static_cast<std::size_t>(floor.step(static_cast<Direction>(d)));
    while (bytes[at] == straight(d) && left > 0) {
      at += ahead;
      --left;
    }
    // A bend is an open cell with line on exactly two sides, one of them behind the robot.
    const unsigned behind = 1u << (d ^ 2);
    const unsigned side = bytes[at] ^ (kOpen | behind);
    if (left == 0 || side == 0 || side == behind || side > kNeighbours || (side & (side - 1)) != 0) break;
    d = static_cast<unsigned>(std::countr_zero(side));
    at += static_cast<std::size_t>(floor.step(static_cast<Direction>(d)));
    --left;
  }
  spot = {at, static_cast<Direction>(d)};
  return most - left;
}

std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most) {
  return walk(table_of(side), floor, spot, most, NoStops{});
}

std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most, const Spot& a,
                      const Spot& b) {
  return walk(table_of(side), floor, spot, most, Stops{a, b});
}

}  // namespace robosim::cells
