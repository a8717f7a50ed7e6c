#include "sim/map/network.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "sim/base/noise.h"

namespace robosim::map::network_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

Network trace(const Map& map, const char* start) { return trace_network(map, parse_start(map, start)); }

// Returns the names of the stations, in the order of their numbers.
std::string order(const Map& map, const char* start) {
  std::string names;
  for (const Station& station : trace(map, start).stations) names += station.name;
  return names;
}

std::vector<CellAt> cells_of(const std::vector<Station>& stations) {
  std::vector<CellAt> cells;
  for (const Station& station : stations) cells.push_back(station.cell);
  return cells;
}

// A smaller version of Robosim v1's sample map. Its seven ends and five forks are connected as in v1's map,
// and its ends have the same letters.
constexpr const char* kV1Tree =
    "+++\n"
    "[stations]\n"
    "A = [4, 1]\nB = [11, 1]\nC = [1, 5]\nD = [15, 4]\nF = [15, 6]\nG = [1, 9]\nH = [15, 9]\n"
    "+++\n"
    "_________________\n"
    "____.______._____\n"
    "____.______._____\n"
    "____.______._____\n"
    "____.______....._\n"
    "_....______._____\n"
    "____.___........_\n"
    "____.___.________\n"
    "____.___.________\n"
    "_..............._\n"
    "_________________\n";

TEST(Network, StationsAreNumberedAsV1NumbersThem) {
  const Map map = parse_map(kV1Tree, "m.map");
  // Robosim v1 prints these orders for its sample map.
  EXPECT_EQ(order(map, "4,1"), "ACGHFDB");
  EXPECT_EQ(order(map, "11,1"), "BACGHFD");
  EXPECT_EQ(order(map, "15,6"), "FDBACGH");
  EXPECT_EQ(order(map, "15,9"), "HFDBACG");
}

TEST(Network, JunctionsAreListedInTheOrderOfTheWalk) {
  const Network network = trace(parse_map(kV1Tree, "m.map"), "4,1");
  EXPECT_THAT(network.junctions,
              ElementsAre(CellAt{4, 5}, CellAt{4, 9}, CellAt{8, 9}, CellAt{11, 6}, CellAt{11, 4}));
  EXPECT_THAT(network.loop, IsEmpty());
  EXPECT_THAT(network.unreachable, IsEmpty());
}

TEST(Network, AStationWithoutANameIsCalledByItsNumber) {
  const Network network = trace(parse_map("...\n", "m.map"), "2,0");
  ASSERT_EQ(network.stations.size(), 2u);
  EXPECT_EQ(network.stations[0].id, 1);
  EXPECT_EQ(network.stations[0].name, "1");
  EXPECT_EQ(network.stations[0].cell, (CellAt{2, 0}));
  EXPECT_EQ(network.stations[1].id, 2);
}

TEST(Network, ASingleCellIsOneStation) {
  EXPECT_THAT(cells_of(trace(parse_map("___\n_1_\n___\n", "m.map"), "1,1").stations),
              ElementsAre(CellAt{1, 1}));
}

TEST(Network, AStartWithinALineIsNoStation) {
  EXPECT_THAT(cells_of(trace(parse_map("....\n", "m.map"), "1,0,E").stations),
              ElementsAre(CellAt{3, 0}, CellAt{0, 0}));
  EXPECT_THAT(cells_of(trace(parse_map("....\n", "m.map"), "1,0,W").stations),
              ElementsAre(CellAt{0, 0}, CellAt{3, 0}));
}

TEST(Network, ACrossingIsLeftToTheRightFirst) {
  const Map map = parse_map("__.__\n__.__\n.....\n__.__\n__.__\n", "m.map");
  const Network network = trace(map, "0,2");
  EXPECT_THAT(cells_of(network.stations),
              ElementsAre(CellAt{0, 2}, CellAt{2, 4}, CellAt{4, 2}, CellAt{2, 0}));
  EXPECT_THAT(network.junctions, ElementsAre(CellAt{2, 2}));
}

TEST(Network, CyclesAreWalkedOnceAndHideNoStation) {
  const Map map = parse_map(
      "_______.__\n"
      "_......._.\n"
      "_._____._.\n"
      "_......._.\n"
      "____._____\n"
      "____._____\n",
      "m.map");
  const Network network = trace(map, "4,5");
  EXPECT_THAT(cells_of(network.stations), ElementsAre(CellAt{4, 5}, CellAt{7, 0}));
  EXPECT_THAT(network.junctions, ElementsAre(CellAt{4, 3}, CellAt{7, 1}));
  EXPECT_THAT(network.unreachable, ElementsAre(CellAt{9, 1}, CellAt{9, 3}));
  EXPECT_THAT(network.loop, IsEmpty());
}

TEST(Network, AnObstacleIsPassedByOnlyAnotherWay) {
  const Network blocked = trace(parse_map("..x...\n", "m.map"), "0,0");
  EXPECT_THAT(cells_of(blocked.stations), ElementsAre(CellAt{0, 0}));
  EXPECT_THAT(blocked.unreachable, ElementsAre(CellAt{5, 0}));
  const Network around = trace(parse_map("_...._\n_.__._\n_.x...\n_.____\n", "m.map"), "1,3");
  EXPECT_THAT(cells_of(around.stations), ElementsAre(CellAt{1, 3}, CellAt{5, 2}));
  EXPECT_THAT(around.unreachable, IsEmpty());
}

TEST(Network, AGapIsPassed) {
  const Map map = parse_map("+++\n[legend]\n5 = \"gap\"\n+++\n..55..\n", "m.map");
  EXPECT_THAT(cells_of(trace(map, "0,0").stations), ElementsAre(CellAt{0, 0}, CellAt{5, 0}));
}

TEST(Network, AWallOnTheLineIsAnObstacleAndNoStation) {
  const Map cut = parse_map("...2...\n", "m.map");
  EXPECT_THAT(cells_of(trace(cut, "0,0").stations), ElementsAre(CellAt{0, 0}));
  EXPECT_THAT(trace(cut, "0,0").unreachable, ElementsAre(CellAt{6, 0}));
  EXPECT_THAT(cells_of(trace(cut, "2,0").stations), ElementsAre(CellAt{0, 0}));
  EXPECT_EQ(default_start(cut).cell, (CellAt{0, 0}));
  EXPECT_EQ(default_start(parse_map("..2..\n.___.\n.___.\n", "m.map")).cell, (CellAt{0, 2}));
  const Network around = trace(parse_map("_....._\n_.___._\n..2....\n_._____\n", "m.map"), "1,3");
  EXPECT_THAT(cells_of(around.stations), ElementsAre(CellAt{1, 3}, CellAt{6, 2}, CellAt{0, 2}));
  EXPECT_THAT(around.unreachable, IsEmpty());
}

TEST(Network, AWallBesideALineOrFarFromTheNextLineIsNoObstacle) {
  EXPECT_EQ(trace(parse_map("..22..\n", "m.map"), "0,0").stations.size(), 2u);
  EXPECT_EQ(trace(parse_map("..2_..\n", "m.map"), "0,0").stations.size(), 2u);
  const Map parallel = parse_map("._.\n.2.\n._.\n", "m.map");
  EXPECT_THAT(cells_of(trace(parallel, "0,0").stations), ElementsAre(CellAt{0, 0}, CellAt{0, 2}));
  EXPECT_FALSE(blocks_line(parallel, {0, 1}, Direction::east));
  // A wall cannot block a line of a single cell.
  EXPECT_THAT(cells_of(trace(parse_map(".2..\n", "m.map"), "0,0").stations), ElementsAre(CellAt{0, 0}));
}

TEST(Network, ALineIsBlockedByAnObstacleAheadFromBothSides) {
  const Map map = parse_map("..x..2..\n", "m.map");
  for (const auto& [cell, d] : {std::pair{CellAt{1, 0}, Direction::east},
                                {CellAt{3, 0}, Direction::west},
                                {CellAt{4, 0}, Direction::east},
                                {CellAt{6, 0}, Direction::west}}) {
    EXPECT_TRUE(blocks_line(map, cell, d)) << cell.x;
    EXPECT_FALSE(blocks_line(map, cell, reversed(d))) << cell.x;
    EXPECT_FALSE(is_dead_end(map, cell)) << cell.x;
  }
}

TEST(Network, NamedPlacesFollowTheDeadEnds) {
  const Map map = parse_map(
      "+++\n[stations]\nmiddle = [2, 0]\nend = [4, 0]\nfar = [1, 2]\n+++\n"
      ".....\n"
      "_____\n"
      "11111\n",
      "m.map");
  const Network network = trace(map, "0,0");
  EXPECT_THAT(cells_of(network.stations), ElementsAre(CellAt{0, 0}, CellAt{4, 0}, CellAt{2, 0}));
  EXPECT_EQ(network.stations[1].name, "end");
  EXPECT_EQ(network.stations[2].name, "middle");
  EXPECT_EQ(network.stations[2].id, 3);
  EXPECT_THAT(network.unreachable, ElementsAre(CellAt{0, 2}, CellAt{4, 2}, CellAt{1, 2}));
}

TEST(Network, ALoopIsListedInTheOrderOfTravel) {
  const Map ring = parse_map("...\n._.\n...\n", "m.map");
  EXPECT_THAT(trace(ring, "0,1,N").loop, ElementsAre(CellAt{0, 1}, CellAt{0, 0}, CellAt{1, 0}, CellAt{2, 0},
                                                     CellAt{2, 1}, CellAt{2, 2}, CellAt{1, 2}, CellAt{0, 2}));
  EXPECT_THAT(trace(ring, "0,1,S").loop.at(1), (CellAt{0, 2}));
}

TEST(Network, AFigureOfEightIsALoopThatPassesItsCrossingTwice) {
  const Map eight = parse_map(
      "__...\n"
      "__._.\n"
      ".....\n"
      "._.__\n"
      "...__\n",
      "m.map");
  const std::vector<CellAt> loop = trace(eight, "1,2,E").loop;
  EXPECT_EQ(loop.size(), 16u);
  EXPECT_EQ(std::count(loop.begin(), loop.end(), CellAt{2, 2}), 2);
  EXPECT_EQ(trace(eight, "2,2,N").loop.size(), 16u);
}

TEST(Network, TwoLoopsThatCrossAreNotOne) {
  const Map map = parse_map(
      ".....__\n"
      ".___.__\n"
      "._.....\n"
      "._._._.\n"
      "....._.\n"
      "__.___.\n"
      "__.....\n",
      "m.map");
  const Network network = trace(map, "0,1");
  EXPECT_THAT(network.junctions, UnorderedElementsAre(CellAt{4, 2}, CellAt{2, 4}));
  EXPECT_THAT(network.stations, IsEmpty());
  EXPECT_THAT(network.loop, IsEmpty());
}

TEST(Network, ALoopWithAnObstacleOrAForkIsNoLoop) {
  EXPECT_THAT(trace(parse_map("..x\n._.\n...\n", "m.map"), "0,1").loop, IsEmpty());
  EXPECT_THAT(trace(parse_map("...\n._.\n...\n.__\n", "m.map"), "0,1").loop, IsEmpty());
}

// Tests random maps of all densities. The walk must end, and every dead end must be numbered or unreachable.
TEST(Network, EveryDeadEndIsNumberedOrUnreachable) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const NoiseStream noise(seed, 0, "map", "test");
    Map map;
    map.width = 1 + static_cast<int>(noise.bits(0) % 14);
    map.height = 1 + static_cast<int>(noise.bits(1) % 14);
    const double density = noise.uniform(2);
    std::size_t dead_ends = 0;
    for (int i = 0; i < map.width * map.height; ++i)
      map.cells.push_back(noise.uniform(static_cast<std::uint64_t>(i) + 3) < density ? Cell::line
                                                                                     : Cell::floor);
    map.cells[0] = Cell::line;
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      const unsigned lines = line_neighbours(map, map.cell_at(i));
      if (is_line(map.cells[i]) && (lines & (lines - 1)) == 0) ++dead_ends;
    }
    const Network network = trace_network(map, default_start(map));
    EXPECT_EQ(network.stations.size() + network.unreachable.size(), dead_ends) << "seed " << seed;
  }
}

}  // namespace robosim::map::network_test
