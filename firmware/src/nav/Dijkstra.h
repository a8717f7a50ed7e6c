// Dijkstra's algorithm: finds the path of least cost on any network.
#ifndef LINEKIT_NAV_DIJKSTRA_H
#define LINEKIT_NAV_DIJKSTRA_H

#include "Plan.h"

namespace nav {

namespace detail {

/// A binary heap of the nodes still to be settled, the nearest first. Also stores each node's heap position.
template <class Id, class Cost>
class NodeHeap {
 public:
  NodeHeap(Id* heap, Id* position, const Cost* distance)
      : heap_(heap), position_(position), distance_(distance) {}

  Id size() const { return size_; }
  void insert(Id node) {
    position_[node] = size_;
    heap_[size_++] = node;
    rise(node);
  }
  /// Moves a node up the heap. Call it after the node's distance has decreased.
  void rise(Id node) {
    Id at = position_[node];
    while (at > 0) {
      const Id above = static_cast<Id>((at - 1) / 2);
      if (distance_[heap_[above]] <= distance_[node]) break;
      put(at, heap_[above]);
      at = above;
    }
    put(at, node);
  }
  Id removeNearest() {
    const Id nearest = heap_[0], node = heap_[--size_];
    Id at = 0;
    while (size_ > 1 && at <= static_cast<Id>((size_ - 2) / 2)) {
      Id below = static_cast<Id>(2 * at + 1);
      if (below + 1 < size_ && distance_[heap_[below + 1]] < distance_[heap_[below]]) ++below;
      if (distance_[node] <= distance_[heap_[below]]) break;
      put(at, heap_[below]);
      at = below;
    }
    if (size_ > 0) put(at, node);
    return nearest;
  }

 private:
  void put(Id at, Id node) {
    heap_[at] = node;
    position_[node] = at;
  }

  Id* heap_;
  Id* position_;
  const Cost* distance_;
  Id size_ = 0;
};

}  // namespace detail

/// Work memory for dijkstra() on `kNodes` nodes, in fixed arrays.
template <unsigned kNodes>
class FixedDijkstraWork {
 public:
  typedef uint16_t Cost;
  uint8_t* room(unsigned count) { return count <= 2 * kNodes ? ids_ : nullptr; }
  Cost* costs(unsigned count) { return count <= kNodes ? costs_ : nullptr; }

 private:
  uint8_t ids_[2 * kNodes];
  Cost costs_[kNodes];
};

/// Finds the path of least cost. A sum of costs that exceeds the range of Work::Cost becomes the greatest
/// Work::Cost. Equally near nodes are settled in an unspecified but repeatable order. The search uses the
/// path's memory for its heap.
template <class Network, class Path, class Work>
Plan dijkstra(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
              Work& work) {
  typedef typename Network::Id Id;
  typedef typename Work::Cost Cost;
  const Cost far = static_cast<Cost>(~Cost(0));
  Id* heap_memory = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, heap_memory);
  if (begun != Plan::found) return begun;
  const Id size = network.size();
  Id* const before = work.room(2 * static_cast<unsigned>(size));
  Cost* const distance = work.costs(size);
  if (before == nullptr || distance == nullptr) return Plan::no_room;
  for (Id i = 0; i < size; ++i) before[i] = Network::kNone;
  detail::NodeHeap<Id, Cost> heap(heap_memory, before + size, distance);
  before[from] = from;
  distance[from] = 0;
  heap.insert(from);
  while (heap.size() > 0) {
    const Id node = heap.removeNearest();
    if (node == to) return detail::backtrack(before, from, to, path, heap_memory);
    const uint8_t count = slots(network, node);
    for (uint8_t slot = 0; slot < count; ++slot) {
      const Id next = network.link(node, slot);
      if (!isOpen(network, node, next)) continue;
      const uint32_t cost = network.cost(node, slot);
      const Cost sum =
          cost < static_cast<Cost>(far - distance[node]) ? static_cast<Cost>(distance[node] + cost) : far;
      if (before[next] == Network::kNone) {
        before[next] = node;
        distance[next] = sum;
        heap.insert(next);
      } else if (sum < distance[next]) {
        before[next] = node;
        distance[next] = sum;
        heap.rise(next);
      }
    }
  }
  return Plan::no_way;
}

/// Finds the next node on the path of least cost, with 17 bits of memory per junction. Stations need no
/// memory, since a path can only begin or end at a station. The network must have the functions row() and
/// junctions(), as FixedNetwork does.
///
/// The search runs from the destination to the robot's node. The last node before the robot's node is the
/// result. All sums of costs stay below 2^16. If the costs are too large, all of them are halved until the
/// sums fit.
template <uint8_t kJunctions>
class DijkstraNext {
 public:
  /// Returns the next node on the path from `here` to `to`, or `here` if both are the same node. Returns
  /// kNone if a node is unknown, there is no path, or the network has more than `kJunctions` junctions.
  template <class Network>
  typename Network::Id next(const Network& network, typename Network::Id here, typename Network::Id to) {
    typedef typename Network::Id Id;
    if (here >= network.size() || to >= network.size() || network.junctions() > kJunctions)
      return Network::kNone;
    if (here == to) return here;
    Id goal = here;
    if (network.isStation(here)) {
      goal = network.link(here, 0);
      if (!isOpen(network, here, goal)) return Network::kNone;
      if (goal == to) return to;
    }
    chooseShift(network);
    for (uint8_t i = 0; i < kJunctions; ++i) distance_[i] = kFar;
    for (uint8_t i = 0; i < sizeof settled_; ++i) settled_[i] = 0;
    if (network.isStation(to)) {
      relax(network, to, 0);
    } else {
      distance_[network.row(to)] = 0;
    }
    Id node;
    do {
      node = settleNearest(network);
      if (node == Network::kNone) return node;
      if (node != goal) relax(network, node, distance_[network.row(node)]);
    } while (node != goal);
    return goal == here ? best(network, here, to) : goal;
  }

 private:
  static constexpr uint16_t kFar = 0xFFFF;

  template <class Network>
  uint16_t length(const Network& network, typename Network::Id node, uint8_t slot) const {
    const uint32_t cost = network.cost(node, slot) >> shift_;
    return cost == 0 ? 1 : static_cast<uint16_t>(cost);
  }

  template <class Network>
  void chooseShift(const Network& network) {
    uint32_t longest = 0;
    for (typename Network::Id node = 0; node < network.size(); ++node) {
      const uint8_t count = network.isStation(node) ? 0 : slots(network, node);
      for (uint8_t slot = 0; slot < count; ++slot) {
        const uint32_t cost = network.cost(node, slot);
        if (cost > longest) longest = cost;
      }
    }
    shift_ = 0;
    while ((longest >> shift_) > (kFar - 1) / (kJunctions + 2U)) ++shift_;
  }

  template <class Network>
  void relax(const Network& network, typename Network::Id node, uint16_t distance) {
    const uint8_t count = slots(network, node);
    for (uint8_t slot = 0; slot < count; ++slot) {
      const typename Network::Id next = network.link(node, slot);
      if (!isOpen(network, node, next) || network.isStation(next)) continue;
      const uint16_t sum = static_cast<uint16_t>(distance + length(network, node, slot));
      uint16_t& known = distance_[network.row(next)];
      if (sum < known) known = sum;
    }
  }

  template <class Network>
  typename Network::Id settleNearest(const Network& network) {
    typename Network::Id nearest = Network::kNone;
    uint16_t least = kFar;
    uint8_t row = 0, nearest_row = 0;
    for (typename Network::Id node = 0; node < network.size(); ++node) {
      if (network.isStation(node)) continue;
      if (distance_[row] < least && (settled_[row / 8] >> row % 8 & 1) == 0) {
        least = distance_[row];
        nearest = node;
        nearest_row = row;
      }
      ++row;
    }
    settled_[nearest_row / 8] = static_cast<uint8_t>(settled_[nearest_row / 8] | 1 << nearest_row % 8);
    return nearest;
  }

  template <class Network>
  typename Network::Id best(const Network& network, typename Network::Id here,
                            typename Network::Id to) const {
    typename Network::Id best = Network::kNone;
    uint16_t least = kFar;
    const uint8_t count = slots(network, here);
    for (uint8_t slot = 0; slot < count; ++slot) {
      const typename Network::Id next = network.link(here, slot);
      if (!isOpen(network, here, next)) continue;
      if (network.isStation(next) && next != to) continue;
      const uint16_t rest = next == to ? 0 : distance_[network.row(next)];
      const uint16_t step = length(network, here, slot);
      if (rest >= kFar - step || rest + step >= least) continue;
      least = static_cast<uint16_t>(rest + step);
      best = next;
    }
    return best;
  }

  uint16_t distance_[kJunctions];
  uint8_t settled_[(kJunctions + 7) / 8];
  uint8_t shift_ = 0;
};

}  // namespace nav

#endif
