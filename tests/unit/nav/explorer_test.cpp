#include "firmware/src/nav/Explorer.h"

#include <gtest/gtest.h>

#include <deque>

#include "firmware/src/nav/FixedNetwork.h"
#include "firmware/src/nav/FixedTree.h"
#include "random_floor.h"
#include "truth.h"

namespace nav_test {
namespace explorer_test {

using nav::Landmark;
using nav::LandmarkKind;
using nav::ScanState;
typedef nav::FixedNetwork<60> Map;
typedef nav::FixedTree<> Tree;

FloorWalker& floorWalker(SeeingWalker& walker) { return walker; }
FloorWalker& floorWalker(BlindWalker& walker) { return walker.walker; }

/// Scans a floor. Expects a correct map of everything that can be reached. Also expects that the robot starts
/// along each line at most once from each end.
template <class Walker, class Network>
void expectScan(Floor& floor, Stand start, Network& network, int32_t drift = 0) {
  Walker walker(floor, start);
  FloorWalker& feet = floorWalker(walker);
  feet.drift = drift;
  nav::Explorer<Walker, Network> explorer(walker, network);
  int steps = 0;
  while (explorer.step()) ASSERT_LT(++steps, 5000);
  ASSERT_EQ(explorer.state(), ScanState::complete);
  EXPECT_EQ(feet.errors, 0);
  ASSERT_EQ(explorer.here(), 0);
  const Arm end = feet.at();
  const int frame = (end.heading - explorer.heading()) & 3;
  if (Walker::kKnowsPlaces) {
    EXPECT_EQ(frame, feet.frame());
  }
  expectTruth(network, floor, {end.node, frame}, Walker::kKnowsPlaces);
  EXPECT_EQ(network.size(), reachable(floor, end.node));
  for (size_t i = 0; i < floor.lines.size(); ++i) {
    EXPECT_LE(feet.runs[i][0], 1) << "line " << i;
    EXPECT_LE(feet.runs[i][1], 1) << "line " << i;
  }
}

constexpr nav::Heading kN = 0, kE = 1, kS = 2, kW = 3;

TEST(Explorer, NumbersStationsAndJunctionsByTheRightHandWalk) {
  // The floor is an H. Stations 0 and 1 end the left bar, and stations 2 and 3 the right bar. The junctions
  // are 4 and 5.
  Floor floor;
  for (int i = 0; i < 6; ++i) floor.addNode();
  floor.join({4, kN}, {0, kS});
  floor.join({4, kS}, {1, kN});
  floor.join({5, kN}, {2, kS});
  floor.join({5, kS}, {3, kN});
  floor.join({4, kE}, {5, kW});
  SeeingWalker walker(floor, {{0, kS}});
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  while (explorer.step()) {
  }
  const std::vector<Found> where = expectTruth(map, floor, {0, walker.frame()}, true);
  std::vector<int> order;
  for (const Found& found : where) order.push_back(found.node);
  EXPECT_EQ(order, (std::vector<int>{0, 4, 1, 5, 3, 2}));
  EXPECT_EQ(nav::stationNode(map, Map::Id(3)), 4);
  EXPECT_EQ(nav::stationNumber(map, Map::Id(5)), 4);
  EXPECT_TRUE(map.isTree());
}

TEST(Explorer, KnowsASpotAloneALineAndALineBegunInItsMiddle) {
  Floor spot;
  spot.addNode();
  Map map;
  SeeingWalker walker(spot, {{0, kE}});
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  EXPECT_FALSE(explorer.step());
  EXPECT_EQ(explorer.state(), ScanState::complete);
  EXPECT_EQ(map.size(), 1);

  Floor line;
  line.addNode();
  line.addNode();
  line.join({0, kE}, {1, kS});
  expectScan<SeeingWalker>(line, {{0, kE}}, map);
  expectScan<SeeingWalker>(line, {{0, kW}}, map);
  expectScan<SeeingWalker>(line, {{0, kE}, true}, map);
  line.lines[0].blocked = true;
  expectScan<SeeingWalker>(line, {{0, kE}}, map);
  EXPECT_EQ(map.size(), 1);
  expectScan<SeeingWalker>(line, {{0, kE}, true}, map);
  EXPECT_EQ(map.size(), 1);
}

TEST(Explorer, ClosesLoopsAndParallelLines) {
  // Three lines join junctions 0 and 1. Another line leads from junction 1 to junction 2, which has a loop.
  Floor floor;
  floor.addNode();
  floor.addNode();
  floor.addNode();
  floor.join({0, kN}, {1, kE}, 5);
  floor.join({0, kE}, {1, kS}, 6);
  floor.join({0, kS}, {1, kW}, 7);
  floor.join({1, kN}, {2, kN}, 8);
  floor.join({2, kE}, {2, kW}, 9);
  Map map;
  for (int node = 0; node < 3; ++node)
    for (nav::Heading h = 0; h < 4; ++h) expectScan<SeeingWalker>(floor, {{node, h}}, map);
  EXPECT_EQ(map.size(), 3);
  EXPECT_FALSE(map.isTree());
}

TEST(Explorer, LearnsRandomTreesWithoutOdometry) {
  for (uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 2 + dice.below(199), dice.oneIn(2));
    for (Floor::Line& line : floor.lines) line.cost = 1;  // a tree stores no costs, and assumes 1
    if (dice.oneIn(3)) blockSome(dice, floor, 20);
    Tree tree;
    expectScan<BlindWalker>(floor, randomStand(dice, floor), tree);
    if (HasFailure()) return;
  }
}

TEST(Explorer, LearnsRandomTreesWithPlaces) {
  for (uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomTree(dice, 2 + dice.below(199), dice.oneIn(2));
    if (dice.oneIn(3)) blockSome(dice, floor, 20);
    Map map;
    expectScan<SeeingWalker>(floor, randomStand(dice, floor), map);
    EXPECT_TRUE(map.isTree());
    if (HasFailure()) return;
  }
}

TEST(Explorer, LearnsRandomNetsWithCycles) {
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 1 + dice.below(64), dice.below(4) * 10);
    if (dice.oneIn(3)) blockSome(dice, floor, 20);
    Map map;
    expectScan<SeeingWalker>(floor, randomStand(dice, floor), map, dice.below(59) - 29);
    if (HasFailure()) return;
  }
}

TEST(Explorer, SaysWhenTheStorageIsFull) {
  for (uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 60, 20);
    SeeingWalker walker(floor, randomStand(dice, floor));
    nav::FixedNetwork<60, 40, 30> small;
    nav::Explorer<SeeingWalker, nav::FixedNetwork<60, 40, 30>> explorer(walker, small);
    while (explorer.step()) {
    }
    EXPECT_EQ(explorer.state(), ScanState::full);
    EXPECT_EQ(walker.errors, 0);
    EXPECT_TRUE(walker.onNode());
    EXPECT_LT(explorer.here(), small.size());
  }
}

TEST(Explorer, FillsATreesStorageOnACycleItCannotRecognise) {
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode();
  for (int i = 0; i < 3; ++i) floor.join({i, kE}, {(i + 1) % 3, kW});
  floor.join({0, kN}, {3, kS});
  floor.join({1, kN}, {2, kN});
  BlindWalker walker(floor, {{3, kS}});
  Tree tree;
  nav::Explorer<BlindWalker, Tree> explorer(walker, tree);
  while (explorer.step()) {
  }
  EXPECT_EQ(explorer.state(), ScanState::full);
  EXPECT_EQ(tree.size(), nav::kTreeNodes);
}

TEST(Explorer, GoesToTheNodeItLeftWhenItsWayBackIsCutOff) {
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode();
  floor.join({0, kE}, {1, kW});
  floor.join({1, kN}, {2, kS});
  const int last = floor.join({1, kS}, {3, kN});
  SeeingWalker walker(floor, {{0, kE}});
  walker.block_line = last;
  walker.block_before = 2;  // cuts off the way back after the nodes 0, 1 and 3
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  while (explorer.step()) {
  }
  EXPECT_EQ(explorer.state(), ScanState::cut_off);
  EXPECT_EQ(walker.errors, 0);
  EXPECT_EQ(walker.at().node, 3);
  EXPECT_EQ(explorer.here(), 2);
  EXPECT_EQ(map.link(2, 0), Map::kBlocked);
}

TEST(Explorer, GoesOnToTheJunctionItKnowsIfAnObstacleCutsItOffBehindACycle) {
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode({100 * i, 0});
  floor.join({0, kE}, {1, kW});
  floor.join({1, kE}, {2, kW});
  floor.join({2, kE}, {3, kW});
  const int round = floor.join({1, kN}, {2, kN});
  SeeingWalker walker(floor, {{0, kE}});
  walker.block_line = round;
  walker.block_before = 5;  // cuts off the way back after the nodes 0, 1, 2, 3, 2 and 1
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  while (explorer.step()) {
  }
  EXPECT_EQ(explorer.state(), ScanState::cut_off);
  EXPECT_EQ(walker.errors, 0);
  EXPECT_EQ(walker.at().node, 1);
  EXPECT_EQ(explorer.here(), 1);
  EXPECT_EQ(map.link(1, 2), Map::kBlocked);
  EXPECT_EQ(map.link(2, 2), Map::kBlocked);
}

TEST(Explorer, DoesNotGoBackToAnObstacleThatItMetBeforeItsFirstNode) {
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode();
  floor.lines[floor.join({0, kE}, {1, kW})].blocked = true;
  floor.join({1, kE}, {2, kW});
  floor.join({1, kN}, {3, kS});
  SeeingWalker walker(floor, {{1, kW}, true});
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  while (explorer.step()) {
  }
  EXPECT_EQ(explorer.state(), ScanState::complete);
  EXPECT_EQ(map.size(), 3);
  EXPECT_EQ(walker.follows, 6) << "once to the obstacle, once to the junction, and twice for each station";
}

/// A walker that ignores its commands, and returns landmarks from a list.
struct ScriptedWalker {
  static const bool kKnowsPlaces = true;
  std::deque<Landmark> script;
  int relocations = 0;

  Landmark begin() { return follow(); }
  Landmark follow() {
    if (script.empty()) return {LandmarkKind::lost, 0, 0, {0, 0}, 0};
    const Landmark next = script.front();
    script.pop_front();
    return next;
  }
  void leave(nav::Turn) {}
  void relocate(const nav::Place&) { ++relocations; }
};

ScanState scripted(std::deque<Landmark> script, Map& map) {
  ScriptedWalker walker{std::move(script)};
  nav::Explorer<ScriptedWalker, Map> explorer(walker, map);
  int steps = 0;
  while (explorer.step() && steps < 100) ++steps;
  return explorer.state();
}

TEST(Explorer, KnowsALoopWithoutAnyNodeAndALineBetweenTwoObstacles) {
  Map map;
  const Landmark line{LandmarkKind::line, 0, 0, {0, 0}, 0}, blocked{LandmarkKind::blocked, 0, 0, {5, 0}, 1};
  EXPECT_EQ(scripted({line, {LandmarkKind::loop, 0, 0, {0, 0}, 30}}, map), ScanState::complete);
  EXPECT_EQ(map.size(), 0);
  EXPECT_EQ(scripted({line, blocked, blocked}, map), ScanState::complete);
  EXPECT_EQ(map.size(), 0);
}

TEST(Explorer, SaysThatTheStorageIsFullIfItCannotKeepTheFirstJunction) {
  Map map;
  const Landmark line{LandmarkKind::line, 0, 0, {0, 0}, 0},
      far{LandmarkKind::junction, 0b1110, 0, {40000, 0}, 9};
  EXPECT_EQ(scripted({far}, map), ScanState::full) << "start on the junction";
  EXPECT_EQ(scripted({line, far}, map), ScanState::full) << "start on a line to the junction";
  EXPECT_EQ(map.size(), 0);
}

TEST(Explorer, IsLostRatherThanLedAstray) {
  Map map;
  const Landmark start{LandmarkKind::end, 1, 0, {0, 0}, 0},
      fork{LandmarkKind::junction, 0b1110, 0, {9, 0}, 9};
  const Landmark stop{LandmarkKind::end, 0b1000, 1, {9, 900}, 9};
  EXPECT_EQ(scripted({}, map), ScanState::lost);
  EXPECT_EQ(scripted({start, {LandmarkKind::junction, 0, 0, {9, 0}, 9}}, map), ScanState::lost) << "no arms";
  EXPECT_EQ(scripted({{LandmarkKind::junction, 0, 0, {9, 0}, 9}}, map), ScanState::lost) << "no arms";
  EXPECT_EQ(scripted({start, fork, stop, stop}, map), ScanState::lost) << "a station instead of the junction";
  EXPECT_EQ(scripted({start, fork, fork}, map), ScanState::lost)
      << "arrival by an arm that is already connected";
  EXPECT_EQ(scripted({start, {LandmarkKind::loop, 0, 0, {9, 0}, 9}}, map), ScanState::lost);
  EXPECT_EQ(scripted({start, {LandmarkKind::junction, 0b1110, 0, {40000, 0}, 9}}, map), ScanState::lost)
      << "too far away for the storage, and no way back in the script";
}

TEST(Explorer, TakesAnArmForOpenThatItComesBackBy) {
  // Two lines join two junctions to a ring. The obstacle on one of these lines disappears after the robot has
  // met the obstacle from one side.
  Floor floor;
  for (int i = 0; i < 4; ++i) floor.addNode();
  floor.join({0, kE}, {1, kW});
  const int ring = floor.join({1, kS}, {2, kS});
  floor.join({1, kE}, {2, kW});
  floor.join({2, kE}, {3, kW});
  floor.lines[ring].blocked = true;
  SeeingWalker walker(floor, {{0, kE}});
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  explorer.step();
  explorer.step();
  explorer.step();  // the robot is back at the junction after meeting the obstacle
  ASSERT_EQ(map.link(1, 1), Map::kBlocked);
  floor.lines[ring].blocked = false;
  while (explorer.step()) {
  }
  EXPECT_EQ(explorer.state(), ScanState::complete);
  EXPECT_EQ(walker.errors, 0);
  expectTruth(map, floor, {0, walker.frame()}, true);
}

TEST(Explorer, ScansAgain) {
  Dice dice(7);
  Floor floor = randomNet(dice, 20, 20);
  SeeingWalker walker(floor, {{0, kE}});
  Map map;
  nav::Explorer<SeeingWalker, Map> explorer(walker, map);
  for (int i = 0; i < 2; ++i) {
    while (explorer.step()) {
    }
    EXPECT_EQ(explorer.state(), ScanState::complete);
    EXPECT_EQ(map.size(), floor.nodes.size());
    explorer.restart();
  }
}

}  // namespace explorer_test
}  // namespace nav_test
