// Planners for a Navigator. They find the next node on the way to a destination.
#ifndef LINEKIT_NAV_NEXT_PLANNERS_H
#define LINEKIT_NAV_NEXT_PLANNERS_H

#include "Dijkstra.h"
#include "Limits.h"
#include "TreeWay.h"

namespace nav {

/// Plans on trees, without memory.
struct ClimbPlanner {
  template <class Network>
  typename Network::Id next(const Network& network, typename Network::Id here, typename Network::Id to) {
    return climbNext(network, here, to);
  }
  void forget() {}
};

/// Plans again at each node, on any FixedNetwork, with 137 bytes of memory for 64 junctions.
template <uint8_t kJunctions = kCyclicJunctions>
class DijkstraPlanner {
 public:
  template <class Network>
  typename Network::Id next(const Network& network, typename Network::Id here, typename Network::Id to) {
    return dijkstra_.next(network, here, to);
  }
  void forget() {}

 private:
  DijkstraNext<kJunctions> dijkstra_;
};

/// Plans as ClimbPlanner if the network is a tree, and as DijkstraPlanner otherwise.
template <uint8_t kJunctions = kCyclicJunctions>
class TreeOrDijkstra {
 public:
  template <class Network>
  typename Network::Id next(const Network& network, typename Network::Id here, typename Network::Id to) {
    return network.isTree() ? climbNext(network, here, to) : dijkstra_.next(network, here, to);
  }
  void forget() {}

 private:
  DijkstraNext<kJunctions> dijkstra_;
};

/// Adapts any planner of Plan.h. Plans the whole path once, and again after forget() or when the robot is off
/// the path. In addition to the members in Plan.h, Path must have size() and [].
///
///   typedef nav::PathPlanner<Network, Path, Work> Planner;
///   Planner planner(nav::bfs<Network, Path, Work>);
///   nav::Navigator<Walker, Network, Planner> navigator(walker, network, planner);
template <class Network, class Path, class Work>
class PathPlanner {
 public:
  typedef typename Network::Id Id;
  typedef Plan (*Function)(const Network&, Id from, Id to, Path&, Work&);

  explicit PathPlanner(Function plan) : plan_(plan) {}

  Id next(const Network& network, Id here, Id to) {
    if (!planned_ || path_[at_] != here) {
      result_ = plan_(network, here, to, path_, work_);
      planned_ = result_ == Plan::found;
      at_ = 0;
    }
    if (!planned_ || at_ + Id(1) >= path_.size()) return Network::kNone;
    return path_[++at_];
  }
  void forget() { planned_ = false; }

  /// Returns the result of the last plan, with the reason for a missing path.
  Plan result() const { return result_; }
  const Path& path() const { return path_; }

 private:
  Function plan_;
  Path path_;
  Work work_;
  Id at_ = 0;
  bool planned_ = false;
  Plan result_ = Plan::found;
};

}  // namespace nav

#endif
