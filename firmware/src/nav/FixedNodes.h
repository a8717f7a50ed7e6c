// Stores the nodes of FixedNetwork.h and FixedTree.h: parents and arms in fixed arrays, with ids of one byte.
// `Memory` (FixedMemory.h) stores everything else.
//
// The nodes are numbered in preorder, so the links need not be stored. The slots 1, 2, 3 of a node lead to
// its children in the order of their ids; the root's slot 0 comes last. Slots with a side line are skipped.
// link() finds a node by a walk through the descendants and the side lines, in about 300 short steps at most.
//
// A network can be saved in EEPROM (kRecordBytes at most):
//
//   network.save(sink);         // sink.put(byte), byte by byte
//   if (network.load(source))   // calls source.get(); false and an empty network if the record is invalid
#ifndef LINEKIT_NAV_FIXED_NODES_H
#define LINEKIT_NAV_FIXED_NODES_H

#include "FixedMemory.h"
#include "Limits.h"
#include "Network.h"
#include "Record.h"

namespace nav {

template <class Memory, uint8_t kNodes>
class FixedNodes {
 public:
  typedef uint8_t Id;
  static constexpr Id kNone = 0xFF;
  static constexpr Id kBlocked = kBlockedArm;
  static constexpr Id kCapacity = kNodes;
  /// The maximum length of a record, in bytes. A record begins with the version, the size, and the number of
  /// junctions. Then follow one bit for each step up and down the tree, the nodes' shapes, the record of
  /// `Memory`, and a checksum.
  static constexpr uint16_t kRecordBytes = 3 + (2 * kNodes + 7) / 8 + kNodes + Memory::kRecordBytes + 2;
  static constexpr bool kPreorder = true;  ///< explorers number nodes in preorder; load() requires it
  static_assert(kNodes > 0 && kNodes < kBlocked, "1 to 253 nodes");

  Id size() const { return size_; }
  Id junctions() const { return junctions_; }
  bool isStation(Id node) const { return (shape_[node] & kJunction) == 0; }
  uint8_t arms(Id node) const { return shape_[node] & 15; }
  Heading entry(Id node) const { return shape_[node] >> 4 & 3; }
  Place place(Id junction) const { return memory_.place(row(junction)); }
  Id parent(Id node) const { return parent_[node]; }

  Id link(Id node, uint8_t slot) const {
    if (isParent(node, slot)) return cut(node) ? kBlocked : parent_[node];
    SideLine other;
    if (memory_.sideLine(node, slot, other)) return other.node;
    const Id child = childBehind(node, slot);
    return child != kNone && cut(child) ? kBlocked : child;
  }
  uint8_t backSlot(Id node, uint8_t slot) const {
    if (isParent(node, slot)) return slotOfChild(parent_[node], node);
    SideLine other;
    return memory_.sideLine(node, slot, other) ? other.slot : 0;
  }
  uint32_t cost(Id node, uint8_t slot) const {
    if (isParent(node, slot)) return costToParent(node);
    SideLine other;
    if (memory_.sideLine(node, slot, other)) return memory_.cost(other);
    const Id child = childBehind(node, slot);
    return child == kNone ? 0 : costToParent(child);
  }
  Id find(const Place& at) const {
    uint8_t row = memory_.find(at);
    for (Id node = 0; node < size_; ++node)
      if (!isStation(node) && row-- == 0) return node;
    return kNone;
  }
  bool isAt(Id junction, const Place& at) const { return find(at) == junction; }
  bool isTree() const { return memory_.joined() == 0; }
  /// Returns whether no line of the depth-first tree is blocked.
  bool allOpen() const { return cuts_ == 0; }
  /// Returns the number of junctions with a smaller id. It serves as an index for tables of junctions.
  uint8_t row(Id node) const {
    uint8_t before = 0;
    for (Id other = 0; other < node; ++other)
      if (!isStation(other)) ++before;
    return before;
  }

  void clear() {
    size_ = junctions_ = cuts_ = 0;
    memory_.clear();
  }
  Id addStation(Id from, uint8_t, uint8_t arms, Heading entry, uint32_t) {
    return size_ < kNodes ? add(from, shapeOf(arms, entry)) : Id(kNone);
  }
  /// Returns the new node. Returns kNone if the memory is full, or if a coordinate does not fit in 16 bits.
  Id addJunction(Id from, uint8_t, uint8_t arms, Heading entry, const Place& at, uint32_t cost) {
    if (size_ >= kNodes || (!isTree() && junctions_ >= kCyclicJunctions) || !memory_.addPlace(at))
      return kNone;
    memory_.setCost(junctions_, cost);
    ++junctions_;
    return add(from, shapeOf(arms, entry) | kJunction);
  }
  bool join(Id a, uint8_t slot_a, Id b, uint8_t slot_b, uint32_t cost) {
    return junctions_ <= kCyclicJunctions && memory_.join(a, slot_a, b, slot_b, cost);
  }
  bool block(Id node, uint8_t slot) {
    if (isParent(node, slot)) {
      cutOff(node);
      return true;
    }
    SideLine other;
    const Id child = memory_.sideLine(node, slot, other) ? Id(kNone) : childBehind(node, slot);
    if (child == kNone) return memory_.block(node, slot);
    cutOff(child);
    return true;
  }

  template <class Sink>
  void save(Sink& sink) const {
    RecordWriter<Sink> record(sink);
    record.put(Memory::kVersion);
    record.put(size_);
    record.put(junctions_);
    for (Id node = 1; node < size_; ++node) {  // the number of steps up from the previous node to the parent
      for (Id at = node - 1; at != parent_[node]; at = parent_[at]) record.putBit(false);
      record.putBit(true);
    }
    for (Id node = 0; node < size_; ++node) record.put(shape_[node]);
    memory_.save(record);
    record.finish();
  }

  template <class Source>
  bool load(Source& source) {
    RecordReader<Source> record(source);
    if (loadNodes(record) && memory_.load(record, junctions_) && record.finish() && isSound()) return true;
    clear();
    return false;
  }

 private:
  // A node's shape consists of its arms, 16 · entry, and these flags:
  static constexpr uint8_t kCut = 0x40;  ///< the line to its parent is blocked
  static constexpr uint8_t kJunction = 0x80;
  static constexpr uint8_t kNoSlot = 0xFF;

  static uint8_t shapeOf(uint8_t arms, Heading entry) {
    return static_cast<uint8_t>((arms & 15) | entry << 4);
  }
  static bool isParent(Id node, uint8_t slot) { return slot == 0 && node != 0; }
  bool cut(Id node) const { return (shape_[node] & kCut) != 0; }
  void cutOff(Id node) {
    shape_[node] |= kCut;
    cuts_ = 1;
  }

  // The cost of a station's only line is arbitrary, because every path to the station contains that line.
  uint32_t costToParent(Id node) const { return isStation(node) ? 1 : memory_.cost(row(node)); }

  Id add(Id from, uint8_t shape) {
    parent_[size_] = from;
    shape_[size_] = shape;
    return size_++;
  }

  // Returns the child at a slot, or kNone. The children are in the order of the slots 1, 2, 3, and finally 0
  // for the root.
  Id childBehind(Id node, uint8_t slot) const {
    SideLine other;
    const uint8_t last = slot == 0 ? slotCount(arms(node)) : slot;
    uint8_t before = 0;
    for (uint8_t s = 1; s < last; ++s)
      if (!memory_.sideLine(node, s, other)) ++before;
    for (Id id = node + 1; id < size_ && parent_[id] >= node; ++id)
      if (parent_[id] == node && before-- == 0) return id;
    return kNone;
  }
  uint8_t slotOfChild(Id node, Id child) const {
    SideLine other;
    uint8_t before = 0;
    for (Id id = node + 1; id < child; ++id)
      if (parent_[id] == node) ++before;
    const uint8_t count = slotCount(arms(node));
    for (uint8_t i = 1; i <= count; ++i) {
      const uint8_t slot = i == count ? 0 : i;
      if (!isParent(node, slot) && !memory_.sideLine(node, slot, other) && before-- == 0) return slot;
    }
    return kNoSlot;
  }

  template <class Record>
  bool loadNodes(Record& record) {
    size_ = cuts_ = 0;
    if (record.get() != Memory::kVersion) return false;
    const Id size = record.get();
    junctions_ = record.get();
    if (size > kNodes || junctions_ > size) return false;
    for (; size_ < size; ++size_) {
      Id up = size_ - 1;
      while (size_ != 0 && !record.getBit()) {
        if (up == 0) return false;
        up = parent_[up];
      }
      parent_[size_] = size_ == 0 ? Id(kNone) : up;
    }
    for (Id node = 0; node < size; ++node) {
      shape_[node] = record.get();
      if (cut(node)) cuts_ = 1;
    }
    return true;
  }

  // Returns whether all functions above can use the loaded data, and no two side lines share an arm.
  bool isSound() const {
    if (row(size_) != junctions_ || (!isTree() && junctions_ > kCyclicJunctions)) return false;
    for (Id node = 0; node < size_; ++node) {
      const uint8_t count = slotCount(arms(node));
      if (!hasArm(arms(node), opposite(entry(node))) && !(size_ == 1 && shape_[0] == shapeOf(0, entry(0))))
        return false;
      if (isStation(node) && count > 1) return false;
      if (node != 0 && slotOfChild(parent_[node], node) == kNoSlot) return false;
    }
    for (uint8_t i = 0; i < memory_.lines(); ++i) {
      uint8_t a, slot_a, b, slot_b;
      memory_.ends(i, a, slot_a, b, slot_b);
      if (!isSoundEnd(i, a, slot_a)) return false;
      if (b != kBlocked && (!isSoundEnd(i, b, slot_b) || (a == b && slot_a == slot_b))) return false;
    }
    return true;
  }
  bool isSoundEnd(uint8_t line, Id node, uint8_t slot) const {
    if (node >= size_ || slot >= slotCount(arms(node)) || isParent(node, slot)) return false;
    for (uint8_t i = 0; i < line; ++i) {
      uint8_t a, slot_a, b, slot_b;
      memory_.ends(i, a, slot_a, b, slot_b);
      if ((a == node && slot_a == slot) || (b == node && slot_b == slot)) return false;
    }
    return true;
  }

  Id parent_[kNodes];
  uint8_t shape_[kNodes];
  Id size_ = 0, junctions_ = 0;
  uint8_t cuts_ = 0;  ///< 1 if any line to a parent is blocked
  Memory memory_;
};

}  // namespace nav

#endif
