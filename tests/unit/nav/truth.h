// Compares a robot's network with the floor that the robot scanned.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "firmware/src/nav/Network.h"
#include "floor.h"

namespace nav_test {

/// The place of a network's node on the floor: the floor's node, and the rotation of the robot's headings at
/// this node.
struct Found {
  int node = -1;
  int frame = 0;
};

/// Returns the place of each node of the network on the floor. Fails the test at the first difference between
/// network and floor: in a node, an arm, a line, a cost or an obstacle.
template <class Network>
std::vector<Found> expectTruth(const Network& network, const Floor& floor, Found root, bool one_frame) {
  std::vector<Found> where(network.size());
  std::map<int, int> known;
  if (network.size() == 0) return where;
  where[0] = root;
  known[root.node] = 0;
  for (typename Network::Id id = 0; id < network.size(); ++id) {
    const int frame = where[id].frame;
    if (one_frame) {
      EXPECT_EQ(frame, root.frame) << "node " << +id;
    }
    const Floor::Node& node = floor.nodes[where[id].node];
    EXPECT_EQ(network.isStation(id), floor.isStation(where[id].node)) << "node " << +id;
    EXPECT_EQ(rotatedArms(network.arms(id), frame), node.arms) << "node " << +id;
    for (uint8_t slot = 0; slot < nav::slots(network, id); ++slot) {
      const Arm arm{where[id].node,
                    static_cast<nav::Heading>((nav::headingOf(network, id, slot) + frame) & 3)};
      const int line = node.line[arm.heading];
      const typename Network::Id next = network.link(id, slot);
      if (line < 0 || next == Network::kNone) {
        ADD_FAILURE() << "node " << +id << " slot " << +slot << " is unknown, or there is no such line";
        return where;
      }
      EXPECT_EQ(next == Network::kBlocked, floor.lines[line].blocked) << "node " << +id << " slot " << +slot;
      if (next == Network::kBlocked) continue;
      const Arm other = floor.across(line, arm);
      const uint8_t back = network.backSlot(id, slot);
      if (where[next].node < 0) {
        EXPECT_EQ(known.count(other.node), 0u);
        where[next] = {other.node, (other.heading - nav::headingOf(network, next, back)) & 3};
        known[other.node] = next;
      }
      EXPECT_EQ(where[next].node, other.node) << "node " << +id << " slot " << +slot;
      EXPECT_EQ((nav::headingOf(network, next, back) + where[next].frame) & 3, other.heading);
      EXPECT_EQ(network.link(next, back), id);
      const bool keeps_cost =
          !network.isStation(id) && !network.isStation(next) && network.junctions() <= nav::kCyclicJunctions;
      if (keeps_cost) {
        EXPECT_EQ(network.cost(id, slot), floor.lines[line].cost);
      }
      if (slot == 0 && id != 0) {
        EXPECT_EQ(network.parent(id), next);
      }
    }
    if (::testing::Test::HasFailure()) return where;
  }
  return where;
}

/// Returns the number of nodes that can be reached from a node without passing an obstacle.
inline int reachable(const Floor& floor, int from) {
  std::vector<int> queue{from};
  std::vector<char> seen(floor.nodes.size());
  seen[from] = 1;
  for (size_t i = 0; i < queue.size(); ++i) {
    for (int h = 0; h < 4; ++h) {
      const int line = floor.nodes[queue[i]].line[h];
      if (line < 0 || floor.lines[line].blocked) continue;
      const int next = floor.across(line, {queue[i], static_cast<nav::Heading>(h)}).node;
      if (!seen[next]) queue.push_back(next);
      seen[next] = 1;
    }
  }
  return static_cast<int>(queue.size());
}

}  // namespace nav_test
