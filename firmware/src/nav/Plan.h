// Common code of all planners. A planner finds a path from one node of a network to another:
//
//   nav::FixedPath<200> path;
//   nav::FixedWork<200> work;
//   if (nav::bfs(network, from, to, path, work) == nav::Plan::found)
//     for (uint8_t i = 0; i < path.size(); ++i) show(path[i]);   // from, …, to
//
// All planners have this form, so that they are interchangeable:
//
//   name        header          finds                        work memory besides the path, n nodes
//   bfs         Search.h        fewest lines                 n ids
//   dfs         Search.h        some path                    n ids
//   iterative   Search.h        fewest lines                 n ids
//   pruned      PrunedBfs.h     the path, on trees           n ids
//   climb       TreeWay.h       the path, on trees           none
//   interval    TreeWay.h       the path, on trees           n ids
//   dijkstra    Dijkstra.h      the least cost               2 n ids, n costs
//
// Planners ignore arms with an obstacle and arms with nothing known beyond them. They also ignore lines from
// a junction to itself. A path does not distinguish parallel lines: slotTowards() returns the cheapest one.
//
// A robot that plans again at each node need not store a path. climbNext() in TreeWay.h takes no memory, and
// DijkstraNext in Dijkstra.h takes 137 bytes for 64 junctions.
//
// A Path is any type with
//   Id* room(count)    returns an array of `count` ids, or nullptr
//   void setSize(n)    sets the number of nodes on the path
// Work memory is any type with
//   Id* room(count)    as above
//   Cost, and Cost* costs(count)    for dijkstra only
// On a host, Path and work memory may grow.
#ifndef LINEKIT_NAV_PLAN_H
#define LINEKIT_NAV_PLAN_H

#include "Network.h"

namespace nav {

enum class Plan : uint8_t {
  found,
  no_way,        ///< no open lines connect the nodes; the path stays empty, as in all cases below
  unknown_node,  ///< `from` or `to` is not a node of the network
  no_room,       ///< the path or the work memory is too small for the network
  not_a_tree,    ///< the planner requires a tree
  not_preorder   ///< the planner requires ids in preorder
};

template <unsigned kRoom>
class FixedPath {
 public:
  typedef uint8_t Id;
  Id* room(unsigned count) { return count <= kRoom ? ids_ : nullptr; }
  void setSize(uint8_t size) { size_ = size; }
  uint8_t size() const { return size_; }
  Id operator[](uint8_t i) const { return ids_[i]; }
  const Id* begin() const { return ids_; }
  const Id* end() const { return ids_ + size_; }

 private:
  Id ids_[kRoom];
  uint8_t size_ = 0;
};

template <unsigned kIds>
class FixedWork {
 public:
  uint8_t* room(unsigned count) { return count <= kIds ? ids_ : nullptr; }

 private:
  uint8_t ids_[kIds];
};

/// Returns whether an arm of `node` has an open line to another node. `behind` is the link() of that arm.
template <class Network>
bool isOpen(const Network&, typename Network::Id node, typename Network::Id behind) {
  return behind != Network::kNone && behind != Network::kBlocked && behind != node;
}

static constexpr uint8_t kNoSlot = 0xFF;

/// Returns the slot of the cheapest open line from a node to its neighbour, or kNoSlot if there is no line.
template <class Network>
uint8_t slotTowards(const Network& network, typename Network::Id node, typename Network::Id neighbour) {
  uint8_t best = kNoSlot;
  uint32_t least = 0;
  const uint8_t count = slots(network, node);
  for (uint8_t slot = 0; slot < count; ++slot) {
    if (neighbour == node || network.link(node, slot) != neighbour) continue;
    const uint32_t cost = network.cost(node, slot);
    if (best != kNoSlot && cost >= least) continue;
    least = cost;
    best = slot;
  }
  return best;
}

/// Returns whether the ids are in the preorder of a depth-first walk. In this order every line connects a
/// node and its parent. The parent is the node with the preceding id, or one of that node's ancestors.
template <class Network>
bool isPreorder(const Network& network) {
  typedef typename Network::Id Id;
  const Id size = network.size();
  for (Id node = 0; node < size; ++node) {
    const Id parent = network.parent(node);
    if (node != 0) {
      if (parent >= node) return false;
      Id at = static_cast<Id>(node - 1);
      while (at > parent) at = network.parent(at);
      if (at != parent) return false;
    }
    const uint8_t count = slots(network, node);
    for (uint8_t slot = 0; slot < count; ++slot) {
      const Id next = network.link(node, slot);
      if (!isOpen(network, node, next) || (node != 0 && next == parent)) continue;
      if (next >= size || network.parent(next) != node) return false;
    }
  }
  return true;
}

namespace detail {

/// Extracts the path to `to` from the predecessor of each node; the predecessor of `from` is `from`.
template <class Id, class Path>
Plan backtrack(const Id* before, Id from, Id to, Path& path, Id* way) {
  Id length = 1;
  for (Id at = to; at != from; at = before[at]) ++length;
  path.setSize(length);
  Id* out = way + length;
  for (Id at = to; at != from; at = before[at]) *--out = at;
  *way = from;
  return Plan::found;
}

/// Checks that the nodes exist, and that the path has memory for all nodes. Sets `way` to that memory.
template <class Network, class Path>
Plan beginPlan(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
               typename Network::Id*& way) {
  path.setSize(0);
  if (from >= network.size() || to >= network.size()) return Plan::unknown_node;
  way = path.room(network.size());
  return way == nullptr ? Plan::no_room : Plan::found;
}

}  // namespace detail

}  // namespace nav

#endif
