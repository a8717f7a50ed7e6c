// Defines two classes for the `Memory` parameter of FixedNodes.h. They store everything except the parents
// and arms of nodes:
//
//   MapMemory   places of junctions, lines that close cycles, costs: for robots with odometry
//   TreeMemory  blocked arms only: for robots without odometry, whose networks must be trees
//
// A "side line" is a line that is not an edge of the depth-first tree: a line that closed a cycle, or an arm
// with an obstacle and nothing known beyond it.
#ifndef LINEKIT_NAV_FIXED_MEMORY_H
#define LINEKIT_NAV_FIXED_MEMORY_H

#include "Landmark.h"

namespace nav {

/// Packs a line's cost in one byte: exact up to 127, then with 16 steps per doubling (3 % off at most),
/// limited to 31744 (ten minutes, in units of 20 ms).
inline uint8_t packCost(uint32_t cost) {
  if (cost < 128) return static_cast<uint8_t>(cost);
  if (cost > 31744) cost = 31744;
  uint8_t shift = 3;
  uint16_t mantissa = static_cast<uint16_t>((cost + 4) >> 3);
  while (mantissa > 31) {
    ++shift;
    mantissa = static_cast<uint16_t>((static_cast<uint16_t>(cost) + (1U << (shift - 1))) >> shift);
  }
  return static_cast<uint8_t>(128 + ((shift - 3) << 4) + (mantissa - 16));
}

inline uint16_t unpackCost(uint8_t packed) {
  if (packed < 128) return packed;
  return static_cast<uint16_t>((16U + (packed & 15U)) << (3 + (packed - 128) / 16));
}

/// The end of an arm that has a side line; `node` is kBlockedArm for an obstacle.
struct SideLine {
  uint8_t node, slot, cost;
};

static constexpr uint8_t kBlockedArm = 0xFE;

/// Stores junctions' positions and side lines in `kCells` shared cells of four bytes: positions from the
/// front, side lines from the back. Two junctions less than `kTolerance` apart, both in x and in y, count as
/// one.
///
/// For the first `kCosts` junctions, it also stores the cost of the line to the parent. Only networks with
/// cycles need costs, and a network with cycles has at most `kCosts` junctions.
template <uint8_t kCosts, uint8_t kCells, uint16_t kTolerance>
class MapMemory {
 public:
  static constexpr uint8_t kVersion = 3;
  static constexpr uint16_t kRecordBytes = 1 + kCosts + 4 * kCells;  ///< maximum

  void clear() { places_ = lines_ = joined_ = 0; }
  uint8_t lines() const { return lines_; }
  /// Returns the number of lines that close cycles.
  uint8_t joined() const { return joined_; }

  bool addPlace(const Place& at) {
    if (places_ + lines_ >= kCells || !fits(at.x) || !fits(at.y)) return false;
    cells_[places_].place = {static_cast<int16_t>(at.x), static_cast<int16_t>(at.y)};
    ++places_;
    return true;
  }
  Place place(uint8_t i) const { return {cells_[i].place.x, cells_[i].place.y}; }
  /// Returns the index of the nearest place within the tolerance, or the number of places if there is none.
  uint8_t find(const Place& at) const {
    uint8_t best = places_;
    uint32_t nearest = kTolerance;
    for (uint8_t i = 0; i < places_; ++i) {
      const uint32_t dx = distance(at.x, cells_[i].place.x), dy = distance(at.y, cells_[i].place.y);
      const uint32_t d = dx > dy ? dx : dy;
      if (d >= nearest) continue;
      nearest = d;
      best = i;
    }
    return best;
  }

  /// Sets the cost of the line from the junction in `row` to its parent.
  void setCost(uint8_t row, uint32_t cost) {
    if (row < kCosts) costs_[row] = packCost(cost);
  }
  uint16_t cost(uint8_t row) const { return row < kCosts ? unpackCost(costs_[row]) : 1; }
  static uint16_t cost(const SideLine& line) { return unpackCost(line.cost); }

  /// Finds the other end of the side line at an arm. Returns false if the arm has no side line.
  bool sideLine(uint8_t node, uint8_t slot, SideLine& other) const {
    for (uint8_t i = 0; i < lines_; ++i) {
      const Line& line = this->line(i);
      const uint8_t slot_a = line.slots & 3, slot_b = line.slots >> 2 & 3;
      if (line.a == node && slot_a == slot) {
        other = {line.b, slot_b, line.cost};
      } else if (line.b == node && slot_b == slot) {
        other = {line.a, slot_a, line.cost};
      } else {
        continue;
      }
      if (line.slots & kBlockedLine) other.node = kBlockedArm;
      return true;
    }
    return false;
  }

  bool join(uint8_t a, uint8_t slot_a, uint8_t b, uint8_t slot_b, uint32_t cost) {
    drop(a, slot_a);
    drop(b, slot_b);
    if (!add(a, slot_a, b, slot_b, packCost(cost))) return false;
    ++joined_;
    return true;
  }
  /// Blocks an arm with nothing known beyond it, or with a side line.
  bool block(uint8_t node, uint8_t slot) {
    for (uint8_t i = 0; i < lines_; ++i) {
      Line& line = this->line(i);
      if ((line.a == node && (line.slots & 3) == slot) || (line.b == node && (line.slots >> 2 & 3) == slot)) {
        line.slots |= kBlockedLine;
        return true;
      }
    }
    return add(node, slot, kBlockedArm, 0, 0);
  }

  template <class Record>
  void save(Record& record) const {
    record.put(lines_);
    for (uint8_t i = 0; i < places_ && i < kCosts; ++i) record.put(costs_[i]);
    for (uint8_t i = 0; i < places_; ++i) {
      put16(record, cells_[i].place.x);
      put16(record, cells_[i].place.y);
    }
    for (uint8_t i = 0; i < lines_; ++i) {
      record.put(line(i).a);
      record.put(line(i).b);
      record.put(line(i).slots);
      record.put(line(i).cost);
    }
  }
  template <class Record>
  bool load(Record& record, uint8_t junctions) {
    clear();
    const uint8_t lines = record.get();
    if (junctions > kCells || lines > kCells - junctions) return false;
    for (uint8_t i = 0; i < junctions && i < kCosts; ++i) costs_[i] = record.get();
    for (places_ = 0; places_ < junctions; ++places_) {
      cells_[places_].place.x = get16(record);
      cells_[places_].place.y = get16(record);
    }
    for (lines_ = 0; lines_ < lines; ++lines_) {
      Line& line = this->line(lines_);
      line.a = record.get();
      line.b = record.get();
      line.slots = record.get();
      line.cost = record.get();
      if (line.b != kBlockedArm) ++joined_;
    }
    return true;
  }
  /// Returns the ends of side line `i`, to check loaded data.
  void ends(uint8_t i, uint8_t& a, uint8_t& slot_a, uint8_t& b, uint8_t& slot_b) const {
    a = line(i).a;
    b = line(i).b;
    slot_a = line(i).slots & 3;
    slot_b = line(i).slots >> 2 & 3;
  }

 private:
  static constexpr uint8_t kBlockedLine = 0x10;

  struct PlaceCell {
    int16_t x, y;
  };
  struct Line {
    uint8_t a, b;
    uint8_t slots;  ///< slot of a | slot of b << 2 | kBlockedLine
    uint8_t cost;
  };
  union Cell {
    PlaceCell place;
    Line line;
  };

  static bool fits(int32_t v) { return v == static_cast<int16_t>(v); }
  static uint32_t distance(int32_t a, int16_t b) {
    const uint32_t d = static_cast<uint32_t>(a) - static_cast<uint32_t>(static_cast<int32_t>(b));
    return a < b ? 0 - d : d;
  }
  template <class Record>
  static void put16(Record& record, int16_t v) {
    record.put(static_cast<uint8_t>(v));
    record.put(static_cast<uint8_t>(static_cast<uint16_t>(v) >> 8));
  }
  template <class Record>
  static int16_t get16(Record& record) {
    const uint8_t low = record.get();
    return static_cast<int16_t>(static_cast<uint16_t>(low | record.get() << 8));
  }

  Line& line(uint8_t i) { return cells_[kCells - 1 - i].line; }
  const Line& line(uint8_t i) const { return cells_[kCells - 1 - i].line; }

  bool add(uint8_t a, uint8_t slot_a, uint8_t b, uint8_t slot_b, uint8_t cost) {
    if (places_ + lines_ >= kCells) return false;
    line(lines_) = {a, b, static_cast<uint8_t>(slot_a | slot_b << 2), cost};
    ++lines_;
    return true;
  }
  // Removes the obstacle recorded at this arm, if there is one.
  void drop(uint8_t node, uint8_t slot) {
    for (uint8_t i = 0; i < lines_; ++i) {
      if (line(i).a != node || (line(i).slots & 3) != slot || line(i).b != kBlockedArm) continue;
      --lines_;
      line(i) = line(lines_);
      return;
    }
  }

  uint8_t costs_[kCosts];
  Cell cells_[kCells];
  uint8_t places_ = 0, lines_ = 0, joined_ = 0;
};

/// Stores two bytes for each blocked arm with nothing known beyond it. Every line costs 1, and no line closes
/// a cycle.
template <uint8_t kBlockedArms>
class TreeMemory {
 public:
  static constexpr uint8_t kVersion = 2;
  static constexpr uint16_t kRecordBytes = 1 + 2 * kBlockedArms;  ///< maximum

  void clear() { lines_ = 0; }
  uint8_t lines() const { return lines_; }
  static uint8_t joined() { return 0; }

  static bool addPlace(const Place&) { return true; }
  static Place place(uint8_t) { return {0, 0}; }
  static uint8_t find(const Place&) { return 0xFF; }

  static void setCost(uint8_t, uint32_t) {}
  static uint16_t cost(uint8_t) { return 1; }
  static uint16_t cost(const SideLine&) { return 1; }

  bool sideLine(uint8_t node, uint8_t slot, SideLine& other) const {
    for (uint8_t i = 0; i < lines_; ++i) {
      if (arms_[i].node != node || arms_[i].slot != slot) continue;
      other = {kBlockedArm, 0, 0};
      return true;
    }
    return false;
  }
  static bool join(uint8_t, uint8_t, uint8_t, uint8_t, uint32_t) { return false; }
  bool block(uint8_t node, uint8_t slot) {
    SideLine known;
    if (sideLine(node, slot, known)) return true;
    if (lines_ >= kBlockedArms) return false;
    arms_[lines_] = {node, slot};
    ++lines_;
    return true;
  }

  template <class Record>
  void save(Record& record) const {
    record.put(lines_);
    for (uint8_t i = 0; i < lines_; ++i) {
      record.put(arms_[i].node);
      record.put(arms_[i].slot);
    }
  }
  template <class Record>
  bool load(Record& record, uint8_t) {
    const uint8_t lines = record.get();
    if (lines > kBlockedArms) return false;
    for (lines_ = 0; lines_ < lines; ++lines_) {
      arms_[lines_].node = record.get();
      arms_[lines_].slot = record.get();
    }
    return true;
  }
  void ends(uint8_t i, uint8_t& a, uint8_t& slot_a, uint8_t& b, uint8_t& slot_b) const {
    a = arms_[i].node;
    slot_a = arms_[i].slot;
    b = kBlockedArm;
    slot_b = 0;
  }

 private:
  struct Arm {
    uint8_t node, slot;
  };
  Arm arms_[kBlockedArms];
  uint8_t lines_ = 0;
};

}  // namespace nav

#endif
