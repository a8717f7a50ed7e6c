// Two planners for trees. They need no search, because they derive the path from the ids of the nodes.
#ifndef LINEKIT_NAV_TREE_WAY_H
#define LINEKIT_NAV_TREE_WAY_H

#include "Plan.h"

namespace nav {

namespace detail {

// Returns the result of the network's allOpen(): whether no line to a parent is blocked. Returns false for a
// network without allOpen(); planners then check each line of a path.
template <class Network>
auto allOpen(const Network& network, int) -> decltype(network.allOpen()) {
  return network.allOpen();
}
template <class Network>
bool allOpen(const Network&, long) {
  return false;
}

// Returns the network's constant kPreorder, or false if it defines none. A network defines kPreorder as true
// if its ids are always in preorder.
template <class Network>
constexpr auto surelyPreorder(int) -> decltype(Network::kPreorder) {
  return Network::kPreorder;
}
template <class Network>
constexpr bool surelyPreorder(long) {
  return false;
}

/// Returns whether all lines of a path are open.
template <class Network>
bool isOpenWay(const Network& network, const typename Network::Id* way, typename Network::Id size) {
  for (typename Network::Id i = 1; i < size; ++i)
    if (network.link(way[i] > way[i - 1] ? way[i] : way[i - 1], 0) == Network::kBlocked) return false;
  return true;
}

}  // namespace detail

/// Climbs from both ends towards the root: replaces the larger of the two ids by its parent's id, until the
/// two ids are equal. A parent's id must be less than its children's ids.
///
/// The path up from `from` grows at the front of the path's memory. The path up from `to` grows from the back
/// downwards. In the end the part at the back moves next to the part at the front. (The loops test at their
/// end, which saves two of some twenty cycles per node on an ATmega.)
template <class Network, class Path>
Plan climb(const Network& network, typename Network::Id from, typename Network::Id to, Path& path) {
  typedef typename Network::Id Id;
  Id* way = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, way);
  if (begun != Plan::found) return begun;
  if (!network.isTree()) return Plan::not_a_tree;
  Id *up = way, *const end = way + network.size(), *down = end;
  constexpr bool sure = detail::surelyPreorder<Network>(0);
  while (from != to) {
    if (from > to) {
      do {
        *up++ = from;
        const Id parent = network.parent(from);
        if (!sure && parent >= from) return Plan::not_preorder;
        from = parent;
      } while (from > to);
    } else {
      do {
        *--down = to;
        const Id parent = network.parent(to);
        if (!sure && parent >= to) return Plan::not_preorder;
        to = parent;
      } while (to > from);
    }
  }
  *up++ = from;
  if (down != end) {
    do {
      *up++ = *down++;
    } while (down != end);
  }
  const Id size = static_cast<Id>(up - way);
  if (!detail::allOpen(network, 0) && !detail::isOpenWay(network, way, size)) return Plan::no_way;
  path.setSize(size);
  return Plan::found;
}
template <class Network, class Path, class Work>
Plan climb(const Network& network, typename Network::Id from, typename Network::Id to, Path& path, Work&) {
  return climb(network, from, to, path);
}

/// Returns the next node on the path from `here` to `to`, by climbing, without work memory. Returns `here` if
/// both are the same node. Returns kNone if a node is unknown or there is no path. The ids must be in
/// preorder, as an explorer numbers nodes.
template <class Network>
typename Network::Id climbNext(const Network& network, typename Network::Id here, typename Network::Id to) {
  typedef typename Network::Id Id;
  if (here >= network.size() || to >= network.size()) return Network::kNone;
  Id from = here, below = to;
  while (from != to) {
    Id& larger = from > to ? from : to;
    const Id parent = network.link(larger, 0);
    if (parent >= larger) return Network::kNone;  // also true for kBlocked
    if (from < to) below = to;
    larger = parent;
  }
  return from == here ? below : network.parent(here);
}

/// Computes the last id beyond each node: its descendants are node + 1 to end[node]. Refuses ids that are not
/// in preorder.
template <class Network>
Plan intervals(const Network& network, typename Network::Id* end) {
  typedef typename Network::Id Id;
  if (!network.isTree()) return Plan::not_a_tree;
  if (!isPreorder(network)) return Plan::not_preorder;
  for (Id node = 0; node < network.size(); ++node) end[node] = node;
  for (Id node = network.size(); node-- > 1;) {
    Id& last = end[network.parent(node)];
    if (last < end[node]) last = end[node];
  }
  return Plan::found;
}

/// Interval routing: goes up to an ancestor of the destination, and then down to the destination. `end` is
/// the result of intervals().
template <class Network, class Path>
Plan intervalWay(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
                 const typename Network::Id* end) {
  typedef typename Network::Id Id;
  Id* way = nullptr;
  const Plan begun = detail::beginPlan(network, from, to, path, way);
  if (begun != Plan::found) return begun;
  Id* out = way;
  *out++ = from;
  while (to < from || to > end[from]) *out++ = from = network.parent(from);
  while (from != to) {
    ++from;  // the first child; the next child's id follows this child's interval
    while (end[from] < to) from = static_cast<Id>(end[from] + 1);
    *out++ = from;
  }
  const Id size = static_cast<Id>(out - way);
  if (!detail::allOpen(network, 0) && !detail::isOpenWay(network, way, size)) return Plan::no_way;
  path.setSize(size);
  return Plan::found;
}

template <class Network, class Path, class Work>
Plan interval(const Network& network, typename Network::Id from, typename Network::Id to, Path& path,
              Work& work) {
  path.setSize(0);
  typename Network::Id* const end = work.room(network.size());
  if (end == nullptr) return Plan::no_room;
  const Plan numbered = intervals(network, end);
  return numbered == Plan::found ? intervalWay(network, from, to, path, end) : numbered;
}

}  // namespace nav

#endif
