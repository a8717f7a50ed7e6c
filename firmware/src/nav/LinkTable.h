// Two simple ways to store a network, for comparing planners: a table of links, as on the robot of the Pony
// paper (docs/howto/research.md), and a table of parents. Neither table stores costs, places or headings.
#ifndef LINEKIT_NAV_LINK_TABLE_H
#define LINEKIT_NAV_LINK_TABLE_H

#include "FixedMemory.h"
#include "Network.h"

namespace nav {

/// Stores `kSlots` links per node, one byte each. The nodes may be numbered in any order. A node's slot 0
/// leads to its parent; slot 0 of node 0 leads to a child.
template <uint8_t kNodes, uint8_t kSlots>
class LinkTable {
 public:
  typedef uint8_t Id;
  static constexpr Id kNone = 0xFF;
  static constexpr Id kBlocked = kBlockedArm;
  static_assert(kNodes < kBlocked && kSlots >= 1 && kSlots <= 4, "1 to 253 nodes with 1 to 4 links");

  /// Sets the number of nodes, and removes all links.
  void clear(Id size) {
    size_ = size < kNodes ? size : kNodes;
    ends_ = 0;
    for (Id node = 0; node < size_; ++node)
      for (uint8_t slot = 0; slot < kSlots; ++slot) links_[node][slot] = kNone;
  }
  /// Sets one direction of a line. Call it once for each slot that has a line.
  void setLink(Id node, uint8_t slot, Id to) {
    links_[node][slot] = to;
    ++ends_;
  }

  Id size() const { return size_; }
  uint8_t arms(Id) const { return (1 << kSlots) - 1; }
  Id parent(Id node) const { return node == 0 ? Id(kNone) : links_[node][0]; }
  Id link(Id node, uint8_t slot) const { return links_[node][slot]; }
  uint32_t cost(Id, uint8_t) const { return 1; }
  bool isTree() const { return ends_ + 2 == 2 * size_; }
  bool isStation(Id node) const {
    uint8_t known = 0;
    for (uint8_t slot = 0; slot < kSlots; ++slot)
      if (links_[node][slot] != kNone) ++known;
    return known < 2;
  }

 private:
  Id links_[kNodes][kSlots];
  uint16_t ends_ = 0;
  Id size_ = 0;
};

/// Stores only the parents of a tree's nodes, one byte each: enough for climb() and intervalWay().
template <uint8_t kNodes>
class ParentTable {
 public:
  typedef uint8_t Id;
  static constexpr Id kNone = 0xFF;
  static constexpr Id kBlocked = kBlockedArm;
  static constexpr bool kPreorder = true;

  void clear() { size_ = 0; }
  /// Adds the next node. The parent of the first node is kNone. Returns false if the parent is not an earlier
  /// node, or the table is full.
  bool add(Id parent) {
    if (size_ >= kNodes || (size_ == 0 ? parent != kNone : parent >= size_)) return false;
    parent_[size_++] = parent;
    return true;
  }

  Id size() const { return size_; }
  Id parent(Id node) const { return parent_[node]; }
  Id link(Id node, uint8_t) const { return parent_[node]; }
  uint8_t arms(Id node) const { return node != 0; }
  static bool isTree() { return true; }
  static bool allOpen() { return true; }

 private:
  Id parent_[kNodes];
  Id size_ = 0;
};

}  // namespace nav

#endif
