// A robot's map of a network of lines. It is a graph whose nodes are numbered in preorder of a depth-first
// walk that takes the right-hand arm first.
//
// A Network is any type with these members; the explorer and the planners are templates with a Network
// parameter. FixedNetwork.h stores a network in fixed arrays with 8-bit ids, for a chip. On a host a network
// may grow.
//
//   Id                                an unsigned type; nodes are 0, 1, 2, … in preorder
//   static const Id kNone             link of an arm with nothing known beyond it (yet); parent of the root
//   static const Id kBlocked          link of an arm with an obstacle
//
//   Id size() const
//   bool isStation(Id) const          true for a station, false for a junction
//   uint8_t arms(Id) const            as in Landmark; a station has one arm, or none if it stands alone
//   Heading entry(Id) const           heading on first entry, which determines slot 0 (Landmark.h)
//   Place place(Id) const             position of a junction
//   Id parent(Id) const               the node from which this node was first entered, beyond slot 0
//   Id link(Id, uint8_t slot) const   the node beyond that arm, or kNone, or kBlocked
//   uint8_t backSlot(Id, uint8_t slot) const    the slot at which this line arrives at link()
//   uint32_t cost(Id, uint8_t slot) const       cost of that line (Landmark::cost); may be 1 for a line to a
//                                               station, because such a cost influences no path
//   Id find(const Place&) const       the junction at that place, or kNone
//   bool isAt(Id junction, const Place&) const   find(place) == junction
//   bool isTree() const               whether every line is an edge of the depth-first tree
//
// A network is built in preorder. The children of a node are added in the order of its slots 1, 2, 3. For
// the root, slot 0 comes last:
//
//   void clear()
//   Id addStation(Id from, uint8_t slot, uint8_t arms, Heading entry, uint32_t cost)        kNone if full
//   Id addJunction(Id from, uint8_t slot, uint8_t arms, Heading entry, Place, uint32_t cost)   kNone if full
//   bool join(Id a, uint8_t slot_a, Id b, uint8_t slot_b, uint32_t cost)
//                                     adds a line between known nodes, or from a node to itself; replaces an
//                                     obstacle recorded beyond these arms; false if full
//   bool block(Id, uint8_t slot)      adds an obstacle at that arm and at the line's other end; false if full
//
// For the root, `from` is kNone, and slot and cost have no meaning. The arm of a station is its slot 0.
#ifndef LINEKIT_NAV_NETWORK_H
#define LINEKIT_NAV_NETWORK_H

#include "Landmark.h"

namespace nav {

/// Returns the number of arms of a node. Its slots are 0 to this number minus 1.
template <class Network>
uint8_t slots(const Network& network, typename Network::Id node) {
  return slotCount(network.arms(node));
}

/// Returns the heading in which the arm in a slot leaves.
template <class Network>
Heading headingOf(const Network& network, typename Network::Id node, uint8_t slot) {
  return headingOf(network.arms(node), network.entry(node), slot);
}

/// Returns the node of station 1, 2, … in the order of discovery, or kNone for an unknown station number.
template <class Network>
typename Network::Id stationNode(const Network& network, typename Network::Id number) {
  for (typename Network::Id node = 0; node < network.size(); ++node)
    if (network.isStation(node) && --number == 0) return node;
  return Network::kNone;
}

/// Returns the number of a station.
template <class Network>
typename Network::Id stationNumber(const Network& network, typename Network::Id node) {
  typename Network::Id number = 0;
  for (typename Network::Id other = 0; other <= node; ++other)
    if (network.isStation(other)) ++number;
  return number;
}

}  // namespace nav

#endif
