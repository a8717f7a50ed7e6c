// Compares all path planners of firmware/src/nav with a reference, on random networks.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>

#include "firmware/src/nav/Dijkstra.h"
#include "firmware/src/nav/Explorer.h"
#include "firmware/src/nav/FixedNetwork.h"
#include "firmware/src/nav/LinkTable.h"
#include "firmware/src/nav/PrunedBfs.h"
#include "firmware/src/nav/Search.h"
#include "firmware/src/nav/TreeWay.h"
#include "random_floor.h"
#include "tests/support/effort.h"

namespace nav_test {
namespace planners_test {

using nav::Plan;
typedef nav::FixedNetwork<60> Map;
typedef nav::LinkTable<200, 4> Links;
typedef std::vector<int> Way;

/// A map that fails the test at a query for a node or an arm that does not exist.
class StrictMap : public Map {
 public:
  bool isStation(Id node) const { return known(node), Map::isStation(node); }
  uint8_t arms(Id node) const { return known(node), Map::arms(node); }
  Id parent(Id node) const { return known(node), Map::parent(node); }
  uint8_t row(Id node) const { return known(node), Map::row(node); }
  Id link(Id node, uint8_t slot) const { return known(node, slot), Map::link(node, slot); }
  uint32_t cost(Id node, uint8_t slot) const { return known(node, slot), Map::cost(node, slot); }

 private:
  void known(Id node, uint8_t slot = 0) const {
    if (node >= size()) ADD_FAILURE() << "node " << +node << " of " << +size();
    if (slot > 0 && slot >= nav::slotCount(Map::arms(node)))
      ADD_FAILURE() << "slot " << +slot << " of node " << +node;
  }
};

template <class Network>
void explore(Dice& dice, Floor& floor, Network& network) {
  SeeingWalker walker(floor, {randomStand(dice, floor).arm});
  nav::Explorer<SeeingWalker, Network> explorer(walker, network);
  while (explorer.step()) {
  }
  ASSERT_EQ(explorer.state(), nav::ScanState::complete);
}

/// Computes the distances of all nodes from one node, by relaxing all lines until nothing changes. This is
/// the reference for all planners.
template <class Network>
std::vector<int> distances(const Network& network, int from, bool by_cost) {
  std::vector<int> far(network.size(), -1);
  far[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int node = 0; node < network.size(); ++node) {
      for (uint8_t slot = 0; far[node] >= 0 && slot < nav::slots(network, node); ++slot) {
        const auto next = network.link(node, slot);
        if (next == Network::kNone || next == Network::kBlocked) continue;
        const int sum = far[node] + (by_cost ? static_cast<int>(network.cost(node, slot)) : 1);
        if (far[next] >= 0 && far[next] <= sum) continue;
        far[next] = sum;
        changed = true;
      }
    }
  }
  return far;
}

/// Returns the number of lines in `way`. If `by_cost` is true, returns their cost instead. Returns -1 if
/// `way` is not a path.
template <class Network>
int length(const Network& network, const Way& way, bool by_cost) {
  int sum = 0;
  for (size_t i = 1; i < way.size(); ++i) {
    const uint8_t slot = nav::slotTowards(network, way[i - 1], way[i]);
    if (slot == nav::kNoSlot) return -1;
    sum += by_cost ? static_cast<int>(network.cost(way[i - 1], slot)) : 1;
  }
  return sum;
}

struct Planned {
  Plan plan;
  Way way;
};

template <class Planner, class Network>
Planned plan(Planner planner, const Network& network, int from, int to) {
  nav::FixedPath<200> path;
  nav::FixedDijkstraWork<200> work;
  const Plan result = planner(network, from, to, path, work);
  return {result, Way(path.begin(), path.end())};
}

#define PLANNER(name) [](auto& n, auto f, auto t, auto& p, auto& w) { return nav::name(n, f, t, p, w); }

/// Expects that `planned` is a path of length `least` between the nodes. If `least` is negative, expects that
/// no path was found.
template <class Network>
void expectWay(const char* name, const Network& network, const Planned& planned, int from, int to, int least,
               bool by_cost) {
  SCOPED_TRACE(std::string(name) + " from " + std::to_string(from) + " to " + std::to_string(to));
  ASSERT_EQ(planned.plan, least < 0 ? Plan::no_way : Plan::found);
  if (least < 0) {
    EXPECT_TRUE(planned.way.empty());
    return;
  }
  ASSERT_FALSE(planned.way.empty());
  EXPECT_EQ(planned.way.front(), from);
  EXPECT_EQ(planned.way.back(), to);
  EXPECT_EQ(length(network, planned.way, by_cost), least);
  EXPECT_EQ(std::set<int>(planned.way.begin(), planned.way.end()).size(), planned.way.size());
}

/// Starts at `from`, and moves from each node to the node that `next` returns for it. Returns the cost of the
/// way to `to`, or a negative number if `next` does not lead to `to`.
template <class Network>
int drive(const Network& network, int from, int to, const std::function<int(int)>& next) {
  Way way{from};
  while (way.back() != to) {
    const int on = next(way.back());
    if (on == Network::kNone) return -1;
    way.push_back(on);
    if (way.size() > 200) return -2;
  }
  return length(network, way, true);
}

/// Checks the planners that work on any network. Each of them plans a path from node `from` to node `to`.
template <class Network>
void expectSearches(const Network& network, int from, int to, const std::vector<int>& lines,
                    const std::vector<int>& costs) {
  expectWay("bfs", network, plan(PLANNER(bfs), network, from, to), from, to, lines[to], false);
  expectWay("iterative", network, plan(PLANNER(iterative), network, from, to), from, to, lines[to], false);
  expectWay("dijkstra", network, plan(PLANNER(dijkstra), network, from, to), from, to, costs[to], true);
  const Planned some = plan(PLANNER(dfs), network, from, to);
  expectWay("dfs", network, some, from, to,
            lines[to] < 0 ? -1 : std::max(0, length(network, some.way, false)), false);
}

template <class Network>
void expectTreePlanners(const Network& network, int from, int to, int lines) {
  expectWay("pruned", network, plan(PLANNER(pruned), network, from, to), from, to, lines, false);
  expectWay("climb", network, plan(PLANNER(climb), network, from, to), from, to, lines, false);
  expectWay("interval", network, plan(PLANNER(interval), network, from, to), from, to, lines, false);
}

/// Returns the links of `network`, without its places, costs and headings.
template <class Network>
Links linksOf(const Network& network) {
  Links links;
  links.clear(network.size());
  for (int node = 0; node < network.size(); ++node) {
    for (uint8_t slot = 0; slot < nav::slots(network, node); ++slot) {
      const auto next = network.link(node, slot);
      if (next != Network::kNone && next != Network::kBlocked) links.setLink(node, slot, next);
    }
  }
  return links;
}

TEST(Planners, AgreeOnThousandsOfTrees) {
  for (uint32_t seed = 0; seed < robosim::test::rounds(3000u); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 2 + dice.below(dice.oneIn(10) ? 199 : 40), dice.oneIn(2));
    Map map;
    explore(dice, floor, map);
    const Links links = linksOf(map);
    nav::ParentTable<200> parents;
    parents.clear();
    for (int node = 0; node < map.size(); ++node) parents.add(map.parent(node));
    EXPECT_TRUE(links.isTree());
    EXPECT_TRUE(nav::isPreorder(map));
    EXPECT_TRUE(nav::isPreorder(links));
    const int from = dice.below(map.size());
    const std::vector<int> lines = distances(map, from, false), costs = distances(map, from, true);
    nav::DijkstraNext<99> dijkstra;
    for (int i = 0; i < 5; ++i) {
      const int to = dice.below(map.size());
      expectSearches(map, from, to, lines, costs);
      expectSearches(links, from, to, lines, lines);
      expectTreePlanners(map, from, to, lines[to]);
      expectTreePlanners(links, from, to, lines[to]);
      EXPECT_EQ(plan(PLANNER(climb), parents, from, to).way, plan(PLANNER(bfs), map, from, to).way);
      EXPECT_EQ(drive(map, from, to, [&](int at) { return nav::climbNext(map, at, to); }), costs[to]);
      EXPECT_EQ(drive(map, from, to, [&](int at) { return dijkstra.next(map, at, to); }), costs[to]);
    }
    if (HasFailure()) return;
  }
}

TEST(Planners, FindThatAnObstacleLeavesNoWayOnATree) {
  for (uint32_t seed = 0; seed < robosim::test::rounds(1000u); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 4 + dice.below(60), dice.oneIn(2));
    Map map;
    explore(dice, floor, map);
    for (int i = 1 + dice.below(3); i > 0; --i) {
      const int node = dice.below(map.size());
      EXPECT_TRUE(map.block(node, dice.below(nav::slots(map, node))));
    }
    const int from = dice.below(map.size());
    const std::vector<int> lines = distances(map, from, false), costs = distances(map, from, true);
    nav::DijkstraNext<64> dijkstra;
    for (int to = 0; to < map.size(); ++to) {
      expectSearches(map, from, to, lines, costs);
      expectTreePlanners(map, from, to, lines[to]);
      EXPECT_EQ(drive(map, from, to, [&](int at) { return nav::climbNext(map, at, to); }), costs[to]);
      EXPECT_EQ(drive(map, from, to, [&](int at) { return dijkstra.next(map, at, to); }), costs[to]);
    }
    if (HasFailure()) return;
  }
}

TEST(Planners, AgreeOnThousandsOfNetsWithCycles) {
  for (uint32_t seed = 0; seed < robosim::test::rounds(2000u); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 1 + dice.below(dice.oneIn(10) ? 64 : 20), dice.below(4) * 20);
    if (dice.oneIn(2)) blockSome(dice, floor, 10);
    StrictMap map;
    explore(dice, floor, map);
    for (int i = dice.below(4); i > 0; --i) {
      const int node = dice.below(map.size());
      EXPECT_TRUE(map.block(node, dice.below(nav::slots(map, node))));
    }
    const int from = dice.below(map.size());
    const std::vector<int> lines = distances(map, from, false), costs = distances(map, from, true);
    nav::DijkstraNext<64> dijkstra;
    for (int i = 0; i < 8; ++i) {
      const int to = dice.below(map.size());
      expectSearches(map, from, to, lines, costs);
      EXPECT_EQ(drive(map, from, to, [&](int at) { return dijkstra.next(map, at, to); }), costs[to]);
      if (!map.isTree()) {
        EXPECT_EQ(plan(PLANNER(pruned), map, from, to).plan, Plan::not_a_tree);
        EXPECT_EQ(plan(PLANNER(climb), map, from, to).plan, Plan::not_a_tree);
        EXPECT_EQ(plan(PLANNER(interval), map, from, to).plan, Plan::not_a_tree);
      }
    }
    if (HasFailure()) return;
  }
}

/// Returns the tree `links` with the new ids `id`. The root keeps its id, and parents stay in slot 0.
Links renumbered(const Links& links, const std::vector<int>& id) {
  Links other;
  other.clear(links.size());
  for (int node = 0; node < links.size(); ++node)
    for (uint8_t slot = 0; slot < 4; ++slot)
      if (links.link(node, slot) != Links::kNone) other.setLink(id[node], slot, id[links.link(node, slot)]);
  return other;
}

TEST(Planners, ThatNeedPreorderRefuseAnyOtherNumbering) {
  int refused = 0;
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 10 + dice.below(50), dice.oneIn(2));
    Map map;
    explore(dice, floor, map);
    std::vector<int> id(map.size());
    std::iota(id.begin(), id.end(), 0);
    // Shuffles all ids except the root's, or exchanges two ids.
    if (dice.oneIn(2)) {
      for (int i = map.size() - 1; i > 1; --i) std::swap(id[i], id[1 + dice.below(i)]);
    } else {
      std::swap(id[1 + dice.below(map.size() - 1)], id[1 + dice.below(map.size() - 1)]);
    }
    const Links links = renumbered(linksOf(map), id);
    const int from = dice.below(map.size()), to = dice.below(map.size());
    const Planned right = plan(PLANNER(bfs), links, from, to);
    ASSERT_EQ(right.plan, Plan::found);
    const bool preorder = nav::isPreorder(links);
    refused += !preorder;
    for (const Planned& planned :
         {plan(PLANNER(pruned), links, from, to), plan(PLANNER(interval), links, from, to)}) {
      EXPECT_EQ(planned.plan, preorder ? Plan::found : Plan::not_preorder);
      if (preorder) {
        EXPECT_EQ(planned.way, right.way);
      }
    }
    const Planned climbed = plan(PLANNER(climb), links, from, to);  // finds the right path, or refuses
    EXPECT_TRUE(climbed.plan == Plan::not_preorder || climbed.way == right.way);
    if (HasFailure()) return;
  }
  EXPECT_GT(refused, 500);
}

TEST(Planners, KnowThatALineWhichClosesACycleIsNoneOfATree) {
  Links links;
  links.clear(3);
  const auto join = [&](std::uint8_t a, std::uint8_t slot_a, std::uint8_t b, std::uint8_t slot_b) {
    links.setLink(a, slot_a, b);
    links.setLink(b, slot_b, a);
  };
  join(0, 0, 1, 0);
  join(1, 1, 2, 0);
  EXPECT_TRUE(nav::isPreorder(links));
  join(2, 1, 0, 1);
  EXPECT_FALSE(nav::isPreorder(links));
}

TEST(Planners, RefuseUnknownNodesAndTooLittleMemory) {
  Dice dice(1);
  Floor floor = randomTree(dice, 20, false);
  Map map;
  explore(dice, floor, map);
  const uint8_t unknown = map.size();
  nav::FixedPath<200> path;
  nav::FixedPath<10> short_path;
  nav::FixedDijkstraWork<200> work;
  nav::FixedDijkstraWork<5> little_work;
  const auto check = [&](const char* name, auto planner, bool needs_work) {
    SCOPED_TRACE(name);
    EXPECT_EQ(planner(map, unknown, 0, path, work), Plan::unknown_node);
    EXPECT_EQ(planner(map, 0, unknown, path, work), Plan::unknown_node);
    EXPECT_EQ(planner(map, 0, Map::kNone, path, work), Plan::unknown_node);
    EXPECT_EQ(planner(map, 0, 1, short_path, work), Plan::no_room);
    EXPECT_EQ(planner(map, 0, 1, path, little_work), needs_work ? Plan::no_room : Plan::found);
    EXPECT_EQ(planner(map, 3, 3, path, work), Plan::found);
    EXPECT_EQ(path.size(), 1);
    EXPECT_EQ(path[0], 3);
    EXPECT_EQ(planner(map, unknown, 3, path, work), Plan::unknown_node);
    EXPECT_EQ(path.size(), 0) << "the previous path is deleted";
  };
  check("bfs", PLANNER(bfs), true);
  check("dfs", PLANNER(dfs), true);
  check("iterative", PLANNER(iterative), true);
  check("pruned", PLANNER(pruned), true);
  check("climb", PLANNER(climb), false);
  check("interval", PLANNER(interval), true);
  check("dijkstra", PLANNER(dijkstra), true);
  EXPECT_EQ(nav::climbNext(map, uint8_t(0), unknown), Map::kNone);
  EXPECT_EQ(nav::climbNext(map, uint8_t(4), uint8_t(4)), 4);
  nav::DijkstraNext<2> small;
  EXPECT_EQ(small.next(map, uint8_t(0), uint8_t(1)), Map::kNone) << "more junctions than memory";
}

TEST(Planners, TakeTheCheapestOpenOneOfParallelLines) {
  Map map;
  map.clear();
  map.addJunction(Map::kNone, 0, 0b1111, 0, {0, 0}, 0);
  map.addJunction(0, 1, 0b1111, 0, {0, 900}, 30);
  map.join(0, 2, 1, 2, 20);
  map.join(0, 3, 1, 1, 25);
  map.join(0, 0, 1, 3, 40);
  EXPECT_EQ(nav::slotTowards(map, 0, 1), 2);
  map.block(1, 2);
  EXPECT_EQ(nav::slotTowards(map, 0, 1), 3);
  map.block(0, 3);
  EXPECT_EQ(nav::slotTowards(map, 0, 1), 1);
  map.block(0, 1);
  EXPECT_EQ(nav::slotTowards(map, 1, 0), 3);
  map.block(0, 0);
  EXPECT_EQ(nav::slotTowards(map, 0, 1), nav::kNoSlot);
}

TEST(Planners, FindTheCheapestWayWhateverTheirMemoryHeld) {
  Map map;
  map.clear();
  map.addJunction(Map::kNone, 0, 0b0111, 0, {0, 0}, 0);
  map.addJunction(0, 1, 0b0111, 0, {100, 0}, 10);
  map.addJunction(1, 1, 0b0111, 0, {200, 0}, 10);
  map.join(2, 1, 0, 2, 100);
  nav::FixedPath<200> path;
  nav::FixedDijkstraWork<200> work;
  std::fill_n(work.costs(map.size()), map.size(), static_cast<nav::FixedDijkstraWork<200>::Cost>(-2));
  ASSERT_EQ(nav::dijkstra(map, 0, 2, path, work), Plan::found);
  EXPECT_EQ(Way(path.begin(), path.end()), (Way{0, 1, 2}));
}

TEST(ParentTable, RefusesAParentThatIsNotBeforeItsChildAndOneNodeTooMany) {
  nav::ParentTable<3> parents;
  parents.clear();
  EXPECT_FALSE(parents.add(0)) << "the first node has no parent";
  EXPECT_TRUE(parents.add(0xFF));
  EXPECT_FALSE(parents.add(1));
  EXPECT_TRUE(parents.add(0));
  EXPECT_TRUE(parents.add(1));
  EXPECT_FALSE(parents.add(1));
  EXPECT_EQ(parents.size(), 3);
}

TEST(DijkstraNext, TakesTheShorterOfTwoWaysOfManyMinutes) {
  Map map;
  map.clear();
  map.addJunction(Map::kNone, 0, 0b0111, 0, {0, 0}, 0);
  map.addJunction(0, 1, 0b0111, 0, {100, 0}, 8000);
  map.addJunction(1, 1, 0b0111, 0, {200, 0}, 8000);
  ASSERT_TRUE(map.join(2, 1, 0, 2, 24000));
  nav::DijkstraNext<64> dijkstra;
  EXPECT_EQ(dijkstra.next(map, 0, 2), 1) << "the way over one more junction takes two thirds of the time";
}

TEST(DijkstraNext, HalvesCostsThatAreTooLongForSixteenBits) {
  // `map` is a row of 64 junctions. Each line between them takes ten minutes.
  Map map;
  map.clear();
  map.addJunction(Map::kNone, 0, 0b0101, 0, {0, 0}, 0);
  for (int i = 1; i < 64; ++i) map.addJunction(i - 1, 1, 0b0101, 0, {100 * i, 0}, 31744);
  // `ring` is this row with one more line, from the last junction to the root's slot 0.
  Map ring;
  ring.clear();
  ring.addJunction(Map::kNone, 0, 0b0101, 0, {0, 0}, 0);
  for (int i = 1; i < 64; ++i) ring.addJunction(i - 1, 1, 0b0101, 0, {100 * i, 0}, 31744);
  ASSERT_TRUE(ring.join(63, 1, 0, 0, 31744));
  nav::DijkstraNext<64> dijkstra;
  EXPECT_EQ(dijkstra.next(map, 0, 63), 1);
  EXPECT_EQ(dijkstra.next(ring, 0, 63), 63);
  EXPECT_EQ(dijkstra.next(ring, 0, 31), 1);
  EXPECT_EQ(dijkstra.next(ring, 0, 33), 63);
  EXPECT_EQ(plan(PLANNER(dijkstra), ring, 0, 63).way, (Way{0, 63})) << "sums that are too large saturate";
}

}  // namespace planners_test
}  // namespace nav_test
