// Pruned BFS, the planner of the Pony paper (docs/howto/research.md): a breadth-first search of a tree. It
// expands at most two nodes of each level.
//
// The ids must be in preorder. In this order the ids of a frontier node and of all nodes beyond it are
// consecutive. Here node 0 counts as the successor of the last node. So the destination is beyond one of two
// frontier nodes: the one with the next smaller id, or the one with the next larger id. The search drops all
// other frontier nodes.
//
// With any other numbering, the search would silently miss most paths. So pruned() first checks the ids, and
// returns not_preorder if they are in another order. The check takes longer than the search. A caller that
// has checked once (isPreorder() in Plan.h) can call prunedSearch() instead.
#ifndef LINEKIT_NAV_PRUNED_BFS_H
#define LINEKIT_NAV_PRUNED_BFS_H

#include "Plan.h"

namespace nav {

namespace detail {

/// The frontier: ids in ascending order. Two nodes have at most six new neighbours; a single node has four.
template <class Id>
struct Frontier {
  Id id[6];
  uint8_t size = 0;

  void insert(Id node) {
    uint8_t i = size++;
    for (; i > 0 && id[i - 1] > node; --i) id[i] = id[i - 1];
    id[i] = node;
  }
  /// Removes all ids except the two between which `to` lies. The order is cyclic: the first id follows the
  /// last.
  void prune(Id to) {
    if (size < 3) return;
    uint8_t above = 0;
    while (above < size && id[above] <= to) ++above;
    const Id next = id[above == size ? 0 : above], last = id[above == 0 ? size - 1 : above - 1];
    id[0] = last;
    id[1] = next;
    size = 2;
  }
};

}  // namespace detail

/// Searches a tree whose ids are known to be in preorder.
template <class Network, class Path, class Work>
Plan prunedSearch(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
                  Work& work) {
  typedef typename Network::Id Id;
  Id* way = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, way);
  if (begun != Plan::found) return begun;
  const Id size = network.size();
  Id* const level = work.room(size);
  if (level == nullptr) return Plan::no_room;
  for (Id i = 0; i < size; ++i) level[i] = Network::kNone;
  detail::Frontier<Id> frontiers[2];
  detail::Frontier<Id>*now = &frontiers[0], *then = &frontiers[1];
  now->insert(from);
  level[from] = 0;
  Id depth = 0;
  while (level[to] == Network::kNone) {
    if (now->size == 0) return Plan::no_way;
    ++depth;
    then->size = 0;
    for (uint8_t i = 0; i < now->size; ++i) {
      const Id node = now->id[i];
      const uint8_t count = slots(network, node);
      for (uint8_t slot = 0; slot < count; ++slot) {
        const Id next = network.link(node, slot);
        if (!isOpen(network, node, next) || level[next] != Network::kNone) continue;
        level[next] = depth;
        then->insert(next);
      }
    }
    then->prune(to);
    detail::Frontier<Id>* const swap = now;
    now = then;
    then = swap;
  }
  path.setSize(static_cast<Id>(depth + 1));
  way[depth] = to;
  while (depth > 0) {  // goes back, level by level
    const Id node = way[depth--];
    uint8_t slot = 0;
    Id next = network.link(node, slot);
    while (!isOpen(network, node, next) || level[next] != depth) next = network.link(node, ++slot);
    way[depth] = next;
  }
  return Plan::found;
}

template <class Network, class Path, class Work>
Plan pruned(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
            Work& work) {
  path.setSize(0);
  if (!network.isTree()) return Plan::not_a_tree;
  if (!isPreorder(network)) return Plan::not_preorder;
  return prunedSearch(network, from, to, path, work);
}

}  // namespace nav

#endif
