#include "firmware/src/nav/Navigator.h"

#include <gtest/gtest.h>

#include <deque>

#include "firmware/src/nav/Explorer.h"
#include "firmware/src/nav/FixedNetwork.h"
#include "firmware/src/nav/FixedTree.h"
#include "firmware/src/nav/NextPlanners.h"
#include "firmware/src/nav/PrunedBfs.h"
#include "firmware/src/nav/Search.h"
#include "random_floor.h"
#include "truth.h"

namespace nav_test {
namespace navigator_test {

using nav::Landmark;
using nav::LandmarkKind;
using nav::NavState;
typedef nav::FixedNetwork<60> Map;
typedef nav::FixedTree<200, 40> Tree;

FloorWalker& floorWalker(SeeingWalker& walker) { return walker; }
FloorWalker& floorWalker(BlindWalker& walker) { return walker.walker; }

/// A robot that has scanned a floor. For each node of the robot's network, `where` contains the floor's node.
template <class Walker, class Network>
struct Scanned {
  Walker walker;
  Network network;
  std::vector<Found> where;
  nav::Heading heading = 0;

  Scanned(Floor& floor, Stand start) : walker(floor, start) {
    nav::Explorer<Walker, Network> explorer(walker, network);
    while (explorer.step()) {
    }
    EXPECT_EQ(explorer.state(), nav::ScanState::complete);
    const Arm at = floorWalker(walker).at();
    heading = explorer.heading();
    where = expectTruth(network, floor, {at.node, (at.heading - heading) & 3}, Walker::kKnowsPlaces);
  }
};

template <class Navigator>
NavState drive(Navigator& navigator) {
  int steps = 0;
  while (navigator.step()) {
    EXPECT_LT(++steps, 2000);
    if (steps >= 2000) break;
  }
  return navigator.state();
}

/// Sends a robot to random nodes while obstacles appear on lines.
template <class Walker, class Network, class Navigator>
void expectTrips(Dice& dice, Floor& floor, Walker& walker, const Network& network,
                 const std::vector<Found>& where, Navigator& navigator) {
  FloorWalker& feet = floorWalker(walker);
  for (int trip = 0; trip < 6; ++trip) {
    SCOPED_TRACE("trip " + std::to_string(trip));
    const int to = dice.below(network.size());
    if (dice.oneIn(2)) {
      feet.block_before = feet.follows + dice.below(5);
      feet.block_line = dice.below(static_cast<int>(floor.lines.size()));
    }
    ASSERT_TRUE(navigator.goTo(to));
    const NavState end = drive(navigator);
    ASSERT_TRUE(feet.onNode());
    EXPECT_EQ(feet.errors, 0);
    EXPECT_EQ(feet.at().node, where[navigator.here()].node);
    if (end == NavState::arrived) {
      EXPECT_EQ(navigator.here(), to);
    } else {
      EXPECT_EQ(end, NavState::no_way);
      // All obstacles on the robot's map are real. If the map has no path, the floor has unreachable nodes.
      nav::FixedPath<200> path;
      nav::FixedWork<200> work;
      EXPECT_EQ(nav::bfs(network, navigator.here(), uint8_t(to), path, work), nav::Plan::no_way);
      Floor known = floor;
      const int reached = reachable(known, feet.at().node);
      EXPECT_LT(reached, network.size());
    }
    feet.block_before = -1;
  }
}

TEST(Navigator, GoesEverywhereOnRandomNetsAndRoundObstacles) {
  int no_ways = 0;
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 2 + dice.below(20), dice.below(3) * 15);
    Scanned<SeeingWalker, Map> robot(floor, randomStand(dice, floor));
    robot.walker.drift = dice.below(59) - 29;
    nav::Navigator<SeeingWalker, Map, nav::TreeOrDijkstra<>> navigator(robot.walker, robot.network);
    navigator.start(0, robot.heading);
    expectTrips(dice, floor, robot.walker, robot.network, robot.where, navigator);
    no_ways += navigator.state() == NavState::no_way;
    if (HasFailure()) return;
  }
  EXPECT_GT(no_ways, 20);
}

TEST(Navigator, GoesEverywhereOnRandomTreesWithoutOdometry) {
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 4 + dice.below(60), dice.oneIn(2));
    for (Floor::Line& line : floor.lines) line.cost = 1;
    Scanned<BlindWalker, Tree> robot(floor, randomStand(dice, floor));
    nav::Navigator<BlindWalker, Tree, nav::ClimbPlanner> navigator(robot.walker, robot.network);
    navigator.start(0, robot.heading);
    expectTrips(dice, floor, robot.walker, robot.network, robot.where, navigator);
    if (HasFailure()) return;
  }
}

TEST(Navigator, TakesTheCheapestWay) {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 2 + dice.below(20), 10);
    for (Floor::Line& line : floor.lines)
      if (floor.isStation(line.a.node) || floor.isStation(line.b.node)) line.cost = 1;  // as networks assume
    Scanned<SeeingWalker, Map> robot(floor, randomStand(dice, floor));
    nav::Navigator<SeeingWalker, Map, nav::TreeOrDijkstra<>> navigator(robot.walker, robot.network);
    navigator.start(0, robot.heading);
    const uint8_t to = dice.below(robot.network.size());
    nav::FixedPath<200> path;
    nav::FixedDijkstraWork<200> work;
    ASSERT_EQ(nav::dijkstra(robot.network, uint8_t(0), to, path, work), nav::Plan::found);
    uint32_t least = 0, driven = 0;
    for (int i = 1; i < path.size(); ++i)
      least += robot.network.cost(path[i - 1], nav::slotTowards(robot.network, path[i - 1], path[i]));
    robot.walker.runs.assign(floor.lines.size(), {0, 0});
    ASSERT_TRUE(navigator.goTo(to));
    EXPECT_EQ(drive(navigator), NavState::arrived);
    for (size_t i = 0; i < floor.lines.size(); ++i)
      driven += floor.lines[i].cost * (robot.walker.runs[i][0] + robot.walker.runs[i][1]);
    EXPECT_EQ(driven, least);
    if (HasFailure()) return;
  }
}

TEST(Navigator, GoesOnAfterAPowerCycle) {
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 2 + dice.below(20), 20);
    Scanned<SeeingWalker, Map> robot(floor, randomStand(dice, floor));
    nav::Navigator<SeeingWalker, Map, nav::TreeOrDijkstra<>> before(robot.walker, robot.network);
    before.start(0, robot.heading);
    ASSERT_TRUE(before.goTo(dice.below(robot.network.size())));
    drive(before);

    SeeingWalker walker(floor, {robot.walker.at()});
    walker.strange = true;
    nav::Navigator<SeeingWalker, Map, nav::TreeOrDijkstra<>> navigator(walker, robot.network);
    ASSERT_TRUE(navigator.restore(before.here(), before.heading()));
    EXPECT_EQ(navigator.state(), NavState::idle);
    expectTrips(dice, floor, walker, robot.network, robot.where, navigator);
    if (HasFailure()) return;
  }
}

TEST(Navigator, GoesOnAfterAPowerCycleWithoutOdometry) {
  for (uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 4 + dice.below(40), dice.oneIn(2));
    for (Floor::Line& line : floor.lines) line.cost = 1;
    Scanned<BlindWalker, Tree> robot(floor, randomStand(dice, floor));
    BlindWalker walker(floor, {robot.walker.walker.at()});
    nav::Navigator<BlindWalker, Tree, nav::ClimbPlanner> navigator(walker, robot.network);
    ASSERT_TRUE(navigator.restore(0, robot.heading));
    expectTrips(dice, floor, walker, robot.network, robot.where, navigator);
    if (HasFailure()) return;
  }
}

TEST(Navigator, RefusesToBeRestoredWhereTheFloorIsAnother) {
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode();
  floor.join({0, 1}, {1, 3});
  floor.join({1, 0}, {2, 2});
  floor.join({1, 1}, {3, 3});
  Scanned<SeeingWalker, Map> robot(floor, {{0, 1}});
  nav::Navigator<SeeingWalker, Map, nav::ClimbPlanner> navigator(robot.walker, robot.network);
  EXPECT_FALSE(navigator.restore(1, 0)) << "a station where a junction should be";
  EXPECT_EQ(navigator.state(), NavState::lost);
  EXPECT_FALSE(navigator.goTo(0));
  EXPECT_FALSE(navigator.restore(4, 0)) << "no such node";
  EXPECT_TRUE(navigator.restore(0, 0));
  EXPECT_TRUE(navigator.goTo(3));
  EXPECT_EQ(drive(navigator), NavState::arrived);

  SeeingWalker elsewhere(floor, {{1, 0}});
  nav::Navigator<SeeingWalker, Map, nav::ClimbPlanner> other(elsewhere, robot.network);
  EXPECT_FALSE(other.restore(1, 2)) << "the junction's arms do not match this heading";
}

TEST(Navigator, RefusesUnknownDestinationsAndIsThereAtOnceWhereItIs) {
  Floor floor;
  for (int i = 0; i < 2; ++i) floor.addNode();
  floor.join({0, 1}, {1, 3});
  Scanned<SeeingWalker, Map> robot(floor, {{0, 1}});
  nav::Navigator<SeeingWalker, Map, nav::ClimbPlanner> navigator(robot.walker, robot.network);
  EXPECT_FALSE(navigator.goTo(1)) << "not started";
  navigator.start(0, robot.heading);
  EXPECT_FALSE(navigator.goTo(2));
  EXPECT_FALSE(navigator.goTo(nav::stationNode(robot.network, Map::Id(3))));
  EXPECT_EQ(navigator.state(), NavState::idle);
  EXPECT_FALSE(navigator.step());
  EXPECT_TRUE(navigator.goTo(0));
  EXPECT_EQ(navigator.state(), NavState::arrived);
  EXPECT_TRUE(navigator.goTo(1));
  EXPECT_EQ(navigator.state(), NavState::driving);
  EXPECT_FALSE(navigator.step());
  EXPECT_EQ(navigator.state(), NavState::arrived);
  EXPECT_EQ(robot.walker.at().node, 1);
}

TEST(Navigator, DrivesByAnyPlannerOfAWay) {
  typedef nav::FixedPath<200> Path;
  typedef nav::FixedDijkstraWork<200> Work;
  typedef nav::PathPlanner<Map, Path, Work> Planner;
  for (uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const bool tree = dice.oneIn(2);
    Floor floor = tree ? randomTree(dice, 4 + dice.below(60), true) : randomNet(dice, 2 + dice.below(20), 10);
    Scanned<SeeingWalker, Map> robot(floor, randomStand(dice, floor));
    std::vector<Planner::Function> planners{nav::bfs<Map, Path, Work>, nav::dfs<Map, Path, Work>,
                                            nav::iterative<Map, Path, Work>, nav::dijkstra<Map, Path, Work>};
    if (robot.network.isTree()) {
      planners.push_back(nav::pruned<Map, Path, Work>);
      planners.push_back(nav::climb<Map, Path, Work>);
      planners.push_back(nav::interval<Map, Path, Work>);
    }
    nav::Heading heading = robot.heading;
    uint8_t here = 0;
    for (const Planner::Function planner : planners) {
      nav::Navigator<SeeingWalker, Map, Planner> navigator(robot.walker, robot.network, Planner(planner));
      navigator.start(here, heading);
      expectTrips(dice, floor, robot.walker, robot.network, robot.where, navigator);
      here = navigator.here();
      heading = navigator.heading();
    }
    if (HasFailure()) return;
  }
}

TEST(PathPlanner, HasNoNextNodeWhereItIs) {
  Map map;
  map.clear();
  map.addStation(Map::kNone, 0, 0b0001, 2, 0);
  map.addJunction(0, 0, 0b0111, 0, {100, 0}, 10);
  map.addStation(1, 1, 0b1000, 1, 10);
  typedef nav::FixedPath<200> Path;
  typedef nav::FixedDijkstraWork<200> Work;
  nav::PathPlanner<Map, Path, Work> planner(nav::dijkstra<Map, Path, Work>);
  EXPECT_EQ(planner.next(map, 0, 2), 1);
  EXPECT_EQ(planner.next(map, 1, 2), 2);
  EXPECT_EQ(planner.next(map, 2, 2), Map::kNone);
  planner.forget();
  EXPECT_EQ(planner.next(map, 2, 2), Map::kNone);
}

/// A walker that ignores its commands, and returns landmarks from a list.
struct ScriptedWalker {
  static const bool kKnowsPlaces = true;
  std::deque<Landmark> script;

  Landmark begin() { return follow(); }
  Landmark follow() {
    if (script.empty()) return {LandmarkKind::lost, 0, 0, {0, 0}, 0};
    const Landmark next = script.front();
    script.pop_front();
    return next;
  }
  void leave(nav::Turn) {}
  void relocate(const nav::Place&) {}
};

NavState scripted(std::deque<Landmark> script) {
  Map map;
  map.clear();
  map.addStation(Map::kNone, 0, 0b0001, 2, 0);
  map.addJunction(0, 0, 0b0111, 0, {100, 0}, 10);
  map.addStation(1, 1, 0b1000, 1, 10);
  ScriptedWalker walker{std::move(script)};
  nav::Navigator<ScriptedWalker, Map, nav::ClimbPlanner> navigator(walker, map);
  navigator.start(0, 0);
  EXPECT_TRUE(navigator.goTo(2));
  return drive(navigator);
}

TEST(Navigator, SaysWhenItIsTrappedOrLost) {
  const Landmark junction{LandmarkKind::junction, 0b0111, 0, {110, 5}, 10},
      blocked{LandmarkKind::blocked, 0, 0, {0, 0}, 1};
  const Landmark end{LandmarkKind::end, 0b1000, 1, {100, 100}, 10};
  EXPECT_EQ(scripted({junction, end}), NavState::arrived);
  EXPECT_EQ(scripted({blocked, blocked}), NavState::trapped);
  EXPECT_EQ(scripted({blocked, end}), NavState::no_way);
  EXPECT_EQ(scripted({junction, blocked, junction}), NavState::lost)
      << "back at the junction with the heading unchanged";
  EXPECT_EQ(scripted({end}), NavState::lost) << "a station instead of the junction";
  EXPECT_EQ(scripted({{LandmarkKind::junction, 0b0111, 1, {100, 0}, 10}, end}), NavState::lost)
      << "at the junction, but with a wrong heading";
  EXPECT_EQ(scripted({{LandmarkKind::junction, 0b0111, 0, {170, 0}, 10}, end}), NavState::lost)
      << "a junction at another place";
  EXPECT_EQ(scripted({}), NavState::lost);
}

}  // namespace navigator_test
}  // namespace nav_test
