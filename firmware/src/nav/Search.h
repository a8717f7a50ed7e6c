// Three textbook planners that search any network: breadth-first, depth-first, iterative deepening.
#ifndef LINEKIT_NAV_SEARCH_H
#define LINEKIT_NAV_SEARCH_H

#include "Plan.h"

namespace nav {

/// Breadth-first search: finds a path with the fewest lines. It visits nodes in the order of their distance
/// from `from`. The search uses the path's memory for its queue.
template <class Network, class Path, class Work>
Plan bfs(const Network& network, typename Network::Id from, typename Network::Id to, Path& path, Work& work) {
  typedef typename Network::Id Id;
  Id* queue = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, queue);
  if (begun != Plan::found) return begun;
  const Id size = network.size();
  Id* const before = work.room(size);
  if (before == nullptr) return Plan::no_room;
  for (Id i = 0; i < size; ++i) before[i] = Network::kNone;
  before[from] = from;
  queue[0] = from;
  Id head = 0, tail = 1;
  while (before[to] == Network::kNone) {
    if (head == tail) return Plan::no_way;
    const Id node = queue[head++];
    const uint8_t count = slots(network, node);
    for (uint8_t slot = 0; slot < count; ++slot) {
      const Id next = network.link(node, slot);
      if (!isOpen(network, node, next) || before[next] != Network::kNone) continue;
      before[next] = node;
      queue[tail++] = next;
    }
  }
  return detail::backtrack(before, from, to, path, queue);
}

/// Depth-first search: finds some path, which may be long if the network has cycles. The search uses the
/// path's memory for its stack.
template <class Network, class Path, class Work>
Plan dfs(const Network& network, typename Network::Id from, typename Network::Id to, Path& path, Work& work) {
  typedef typename Network::Id Id;
  Id* stack = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, stack);
  if (begun != Plan::found) return begun;
  const Id size = network.size();
  Id* const seen = work.room(size);
  if (seen == nullptr) return Plan::no_room;
  for (Id i = 0; i < size; ++i) seen[i] = 0;
  Id node = from, depth = 0;
  seen[node] = 1;
  stack[0] = node;
  while (node != to) {
    const uint8_t count = slots(network, node);
    Id next = Network::kNone;
    for (uint8_t slot = 0; slot < count; ++slot) {
      next = network.link(node, slot);
      if (isOpen(network, node, next) && !seen[next]) break;
      next = Network::kNone;
    }
    if (next != Network::kNone) {
      seen[next] = 1;
      stack[++depth] = next;
    } else if (depth == 0) {
      return Plan::no_way;
    } else {
      --depth;
    }
    node = stack[depth];
  }
  path.setSize(static_cast<Id>(depth + 1));
  return Plan::found;
}

namespace detail {

enum class Dive : uint8_t { found, not_found, too_deep };

/// Searches depth-first, `limit` lines deep at most. `best` stores the least depth at which each node was
/// seen. A node is expanded again only at a smaller depth.
template <class Network>
Dive dive(const Network& network, typename Network::Id from, typename Network::Id to,
          typename Network::Id limit, typename Network::Id* stack, typename Network::Id* best) {
  typedef typename Network::Id Id;
  for (Id i = 0; i < network.size(); ++i) best[i] = Network::kNone;
  Dive result = Dive::not_found;
  Id node = from, depth = 0;
  best[node] = 0;
  stack[0] = node;
  while (node != to) {
    const uint8_t count = slots(network, node);
    Id next = Network::kNone;
    for (uint8_t slot = 0; slot < count; ++slot) {
      next = network.link(node, slot);
      if (isOpen(network, node, next) && best[next] > depth + 1) break;
      next = Network::kNone;
    }
    if (next != Network::kNone && depth == limit) {
      result = Dive::too_deep;
      next = Network::kNone;
    }
    if (next != Network::kNone) {
      stack[++depth] = next;
      best[next] = depth;
    } else if (depth == 0) {
      return result;
    } else {
      --depth;
    }
    node = stack[depth];
  }
  return Dive::found;
}

}  // namespace detail

/// Iterative deepening: repeats a depth-first search, and raises the depth limit by one line each time. Finds
/// a path with the fewest lines.
template <class Network, class Path, class Work>
Plan iterative(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
               Work& work) {
  typedef typename Network::Id Id;
  Id* stack = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, stack);
  if (begun != Plan::found) return begun;
  Id* const best = work.room(network.size());
  if (best == nullptr) return Plan::no_room;
  for (Id limit = 0; limit < network.size(); ++limit) {
    const detail::Dive result = detail::dive(network, from, to, limit, stack, best);
    if (result == detail::Dive::not_found) return Plan::no_way;
    if (result == detail::Dive::too_deep) continue;
    path.setSize(static_cast<Id>(limit + 1));
    return Plan::found;
  }
  return Plan::no_way;
}

}  // namespace nav

#endif
