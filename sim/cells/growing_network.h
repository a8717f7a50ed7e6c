// What the explorer has found, in arrays that grow: a Network (firmware/src/nav/Network.h) for a host.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "firmware/src/nav/Network.h"

namespace robosim::cells {

class GrowingNetwork {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xFFFFFFFF;
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
  Id find(const nav::Place& place) const;
  bool isAt(Id junction, const nav::Place& at) const {
    return place(junction).x == at.x && place(junction).y == at.y;
  }
  bool isTree() const { return is_tree_; }

  void clear();
  Id addStation(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, std::uint32_t cost);
  Id addJunction(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, const nav::Place& place,
                 std::uint32_t cost);
  bool join(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost);
  bool block(Id node, std::uint8_t slot);

 private:
  struct Line {
    Id to = kNone;
    std::uint32_t cost : 24 = 0;
    std::uint32_t back : 8 = 0;
  };
  struct Node {
    Id parent = kNone;
    Id junction = kNone;  ///< its number among junctions_; a station has none
    std::uint8_t arms = 0;
    nav::Heading entry = 0;
    Line first;  ///< a station's only line
  };
  struct Junction {
    std::array<Line, 4> lines;
    nav::Place place;
  };

  const Line& line(Id node, std::uint8_t slot) const {
    const Node& n = nodes_[node];
    return n.junction == kNone ? n.first : junctions_[n.junction].lines[slot];
  }
  Line& line(Id node, std::uint8_t slot) { return const_cast<Line&>(std::as_const(*this).line(node, slot)); }
  Id add(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, std::uint32_t cost, Id junction);
  void connect(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost);
  void index(Id node, const nav::Place& place);
  std::size_t slot_of(const nav::Place& place) const;

  std::vector<Node> nodes_;
  std::vector<Junction> junctions_;
  bool is_tree_ = true;
  std::vector<Id> index_;  ///< open addressing, at most half full
};

}  // namespace robosim::cells
