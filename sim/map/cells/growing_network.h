// Implements the explorer's map, a Network (firmware/src/nav/Network.h), with arrays that grow, for programs
// on a host.
//
// Places are cells of a map, so they are never negative.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "firmware/src/nav/Network.h"
#include "sim/map/cells/chunks.h"
#include "sim/map/cells/junction_index.h"

namespace robosim::cells {

class GrowingNetwork {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = JunctionIndex::kNone;
  static constexpr Id kBlocked = 0xFFFFFFFE;

  Id size() const { return static_cast<Id>(nodes_.size()); }
  bool isStation(Id node) const { return nodes_[node].junction == kNone; }
  std::uint8_t arms(Id node) const { return nodes_[node].arms; }
  nav::Heading entry(Id node) const { return nodes_[node].entry; }
  nav::Place place(Id node) const { return junctions_[nodes_[node].junction].place; }
  Id parent(Id node) const { return nodes_[node].parent; }
  Id link(Id node, std::uint8_t slot) const { return line(node, slot).to; }
  std::uint8_t backSlot(Id node, std::uint8_t slot) const { return line(node, slot).back; }
  std::uint32_t cost(Id node, std::uint8_t slot) const { return line(node, slot).cost; }
  Id find(const nav::Place& place) const { return index_.find(place); }
  bool isAt(Id junction, const nav::Place& at) const {
    const nav::Place& here = junctions_[nodes_[junction].junction].place;
    return here.x == at.x && here.y == at.y;
  }
  bool isTree() const { return is_tree_; }
  /// Returns the same heading as nav::headingOf(). Reads the heading from the node, instead of computing it
  /// from the node's arms.
  nav::Heading heading(Id node, std::uint8_t slot) const {
    return static_cast<nav::Heading>(nodes_[node].headings >> 2 * slot & 3);
  }

  void clear();
  Id addStation(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, std::uint32_t cost) {
    return add(from, slot, arms, entry, cost, kNone);
  }
  Id addJunction(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, const nav::Place& place,
                 std::uint32_t cost) {
    junctions_.push_back({{kNoLine, kNoLine, kNoLine}, place});
    const Id node = add(from, slot, arms, entry, cost, static_cast<Id>(junctions_.size() - 1));
    index_.add(place, node);
    return node;
  }
  bool join(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost);
  bool block(Id node, std::uint8_t slot);

 private:
  static constexpr std::uint32_t kLongest = (1u << 24) - 1;
  struct Line {
    Id to;
    std::uint32_t cost : 24;
    std::uint32_t back : 8;  ///< slot at the other end
  };
  static constexpr Line kNoLine{kNone, 0, 0};
  struct Node {
    Id parent;
    Id junction;  ///< index in junctions_; unset for a station
    std::uint8_t arms;
    nav::Heading entry;
    std::uint8_t headings;  ///< two bits for each slot
    Line first;             ///< line in slot 0
  };
  struct Junction {
    std::array<Line, 3> others;  ///< lines in slots 1, 2, 3
    nav::Place place;
  };

  const Line& line(Id node, std::uint8_t slot) const {
    const Node& n = nodes_[node];
    return slot == 0 ? n.first : junctions_[n.junction].others[slot - 1u];
  }
  Line& line(Id node, std::uint8_t slot) {
    Node& n = nodes_[node];
    return slot == 0 ? n.first : junctions_[n.junction].others[slot - 1u];
  }
  static std::uint8_t headings_of(std::uint8_t arms, nav::Heading entry);
  Id add(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, std::uint32_t cost, Id junction) {
    const Id node = size();
    cost = std::min(cost, kLongest);
    const Line back = from == kNone ? kNoLine : Line{from, cost, slot};
    nodes_.push_back({from, junction, arms, entry, headings_of(arms, entry), back});
    if (from != kNone) line(from, slot) = {node, cost, 0};
    return node;
  }

  Chunks<Node> nodes_;
  Chunks<Junction> junctions_;
  JunctionIndex index_;
  bool is_tree_ = true;
};

/// Replaces nav::headingOf() in nav's templates, which find this overload by argument-dependent lookup.
template <std::derived_from<GrowingNetwork> Network>
nav::Heading headingOf(const Network& network, typename Network::Id node, std::uint8_t slot) {
  return network.heading(node, slot);
}

}  // namespace robosim::cells
