// Tests the heap of Dijkstra's algorithm.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "firmware/src/nav/Dijkstra.h"
#include "random_floor.h"

namespace nav_test {
namespace node_heap_test {

// Tests the heap without a network, because a disordered heap causes a wrong path only one time in a
// thousand.
TEST(NodeHeap, GivesTheNearestFirstAlsoWhenOthersHaveComeNearer) {
  constexpr uint8_t kNodes = 40;
  for (uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    uint8_t heap_memory[kNodes], position[kNodes];
    uint16_t distance[kNodes];
    nav::detail::NodeHeap<uint8_t, uint16_t> heap(heap_memory, position, distance);
    std::vector<uint8_t> inside;
    uint8_t next = 0;
    while (next < kNodes || !inside.empty()) {
      if (next < kNodes && (inside.empty() || !dice.oneIn(3))) {
        distance[next] = static_cast<uint16_t>(dice.below(100));
        inside.push_back(next);
        heap.insert(next++);
      } else if (dice.oneIn(2)) {
        const uint8_t node = inside[dice.below(static_cast<int>(inside.size()))];
        distance[node] = static_cast<uint16_t>(dice.below(distance[node] + 1));
        heap.rise(node);
      } else {
        const auto nearest = std::min_element(inside.begin(), inside.end(),
                                              [&](int a, int b) { return distance[a] < distance[b]; });
        const uint16_t least = distance[*nearest];
        const uint8_t node = heap.removeNearest();
        ASSERT_EQ(distance[node], least);
        const auto at = std::find(inside.begin(), inside.end(), node);
        ASSERT_NE(at, inside.end()) << "the node was removed before";
        inside.erase(at);
      }
      ASSERT_EQ(heap.size(), inside.size());
    }
  }
}

}  // namespace node_heap_test
}  // namespace nav_test
