// A Network (Network.h) in fixed arrays (FixedNodes.h), for a robot without odometry. The network stores no
// positions of junctions, and must not have cycles.
//
//   nav::FixedTree<> network;
//
// RAM: 2 bytes per node, and 2 for each of 16 blocked arms: 436 bytes for 200 nodes.
#ifndef LINEKIT_NAV_FIXED_TREE_H
#define LINEKIT_NAV_FIXED_TREE_H

#include "FixedNodes.h"

namespace nav {

template <uint8_t kNodes = kTreeNodes, uint8_t kBlockedArms = 16>
using FixedTree = FixedNodes<TreeMemory<kBlockedArms>, kNodes>;

LINEKIT_LIMIT_GROWS(nodes_of_a_tree, 2, 253);
static_assert(sizeof(FixedTree<202>) - sizeof(FixedTree<200>) == 2 * 2, "2 bytes each");

}  // namespace nav

#endif
