// A Network (Network.h) in fixed arrays (FixedNodes.h): for a chip with 2 KB of RAM.
//
//   nav::FixedNetwork<60> network;   // junctions less than 60 (mm) apart count as one
//
// RAM, on an ATmega328P, for 200 nodes:
//
//   parents, arms                  2 bytes per node              400
//   costs                          64 bytes                       64
//   junctions' places, side lines  4 bytes for each of these,
//                                  130 in all                    520
//   in all                                                       990 bytes
//
// A side line is a line that closes a cycle, or a blocked arm with nothing known beyond it. A tree of 200
// nodes has at most 99 junctions, so the 130 cells (4 bytes each) have room for 31 blocked arms as well. Or
// they have room for 64 junctions whose four arms are all joined, with 65 lines that close cycles. If no cell
// is free, adding a junction or a side line fails. In EEPROM a full network takes about 840 bytes.
#ifndef LINEKIT_NAV_FIXED_NETWORK_H
#define LINEKIT_NAV_FIXED_NETWORK_H

#include "FixedNodes.h"

namespace nav {

template <uint16_t kTolerance, uint8_t kNodes = kTreeNodes, uint8_t kCells = kNodes / 2 + 30>
using FixedNetwork = FixedNodes<MapMemory<kCyclicJunctions, kCells, kTolerance>, kNodes>;

// A node takes two bytes. At most every second node is a junction, which takes four more bytes. So each node
// takes at most 4 bytes on average.
LINEKIT_LIMIT_GROWS(nodes_of_a_tree, 4, 253);
static_assert(sizeof(FixedNetwork<1, 202>) - sizeof(FixedNetwork<1, 200>) == 2 * 4, "4 bytes each");

}  // namespace nav

#endif
