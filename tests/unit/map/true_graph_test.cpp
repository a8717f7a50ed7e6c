#include "sim/map/true_graph.h"

#include <gmock/gmock.h>

#include <queue>
#include <string>

#include "sim/base/error.h"
#include "sim/base/noise.h"
#include "sim/map/network.h"

namespace robosim::map::true_graph_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Behind = Arm::Behind;

TrueGraph graph_of(const Map& map, const char* start) { return true_graph(map, parse_start(map, start)); }

// Formats a junction's slots, such as "1:0 (2) - x". These slots lead to slot 0 of junction 1, to station 2,
// to nothing, and to a blocked line.
std::string slots(const GraphJunction& junction) {
  std::string text;
  for (const Arm& arm : junction.arms) {
    if (!text.empty()) text += ' ';
    if (arm.behind == Behind::nothing) text += '-';
    if (arm.behind == Behind::blocked) text += 'x';
    if (arm.behind == Behind::station) text += '(' + std::to_string(arm.id) + ')';
    if (arm.behind == Behind::junction) text += std::to_string(arm.id) + ':' + std::to_string(arm.slot);
  }
  return text;
}

std::string slots(const TrueGraph& graph) {
  std::string text;
  for (const GraphJunction& junction : graph.junctions) text += (text.empty() ? "" : ", ") + slots(junction);
  return text;
}

TEST(TrueGraph, OfALineWithBendsIsTwoStations) {
  const TrueGraph graph = graph_of(parse_map("...___\n__.___\n__....\n", "m.map"), "0,0");
  ASSERT_EQ(graph.stations.size(), 2u);
  EXPECT_THAT(graph.junctions, IsEmpty());
  EXPECT_EQ(graph.stations[1].cell, (CellAt{5, 2}));
  EXPECT_EQ(graph.stations[0].arm, (Arm{Direction::east, Behind::station, 2, 0, 7, {}}));
  EXPECT_EQ(graph.stations[1].arm, (Arm{Direction::west, Behind::station, 1, 0, 7, {}}));
  EXPECT_EQ(line_count(graph), 1u);
  EXPECT_EQ(cycle_count(graph), 0u);
}

TEST(TrueGraph, SlotsFollowToTheRightHandFromTheArmFirstEnteredBy) {
  const Map map = parse_map("__.__\n__.__\n.....\n__.__\n__.__\n", "m.map");
  EXPECT_EQ(slots(graph_of(map, "0,2")), "(1) (2) (3) (4)");
  const TrueGraph graph = graph_of(map, "2,0");
  EXPECT_EQ(slots(graph), "(1) (2) (3) (4)");
  EXPECT_EQ(graph.junctions[0].arms[0].out, Direction::north);
  EXPECT_EQ(graph.junctions[0].arms[1].out, Direction::west);
  EXPECT_EQ(graph.stations[1].cell, (CellAt{0, 2}));
}

constexpr const char* kRing =
    "_______.__\n"
    "_.......__\n"
    "_._____.__\n"
    "_.......__\n"
    "____._____\n"
    "____._____\n";

TEST(TrueGraph, OfACycleHasEachJunctionOnceAndBothEndsOfALineKnowEachOther) {
  const TrueGraph graph = graph_of(parse_map(kRing, "m.map"), "4,5");
  EXPECT_EQ(slots(graph), "(1) 2:0 2:2, 1:1 (2) 1:2");
  EXPECT_EQ(graph.junctions[0].arms[1].length, 5);
  EXPECT_EQ(graph.junctions[1].arms[0].length, 5);
  EXPECT_EQ(graph.junctions[1].arms[2].length, 11);
  EXPECT_EQ(line_count(graph), 4u);
  EXPECT_EQ(cycle_count(graph), 1u);
}

TEST(TrueGraph, AStartOnAJunctionWalksTheArmBehindItLast) {
  const Map map = parse_map("__.__\n__.__\n.....\n", "m.map");
  const TrueGraph east = graph_of(map, "2,2,E");
  EXPECT_EQ(slots(east), "(3) (1) (2)");  // back, straight and left; there is no arm to the right
  EXPECT_EQ(east.stations[0].cell, (CellAt{4, 2}));
  EXPECT_EQ(east.stations[1].cell, (CellAt{2, 0}));
  const TrueGraph south = graph_of(map, "2,2,S");
  EXPECT_EQ(south.stations[0].cell, (CellAt{0, 2}));
  EXPECT_EQ(slots(south), "(3) (1) (2)");
}

TEST(TrueGraph, AStartWithinALineHasTheNextNodeForItsRoot) {
  const Map map = parse_map("__.__\n__.__\n.....\n", "m.map");
  EXPECT_EQ(slots(graph_of(map, "1,2,E")), "(3) (1) (2)");
  const TrueGraph west = graph_of(map, "1,2,W");
  EXPECT_EQ(slots(west), "(1) (2) (3)");
  EXPECT_EQ(west.stations[0].cell, (CellAt{0, 2}));
  EXPECT_EQ(west.stations[0].arm.length, 2);
}

TEST(TrueGraph, AStartAtADeadEndIsItsRootWhicheverWayItFaces) {
  const Map map = read_map(find_map("d"));
  const TrueGraph graph = graph_of(map, "3,10,E");
  for (const char* start : {"3,10,S", "3,10,W", "3,10,N"}) EXPECT_EQ(graph_of(map, start), graph) << start;
}

TEST(TrueGraph, ALineMayEndAtTheMapsEdge) {
  const TrueGraph graph = graph_of(parse_map("_._\n...\n_._\n", "m.map"), "0,1,W");
  EXPECT_EQ(slots(graph), "(1) (2) (3) (4)");
  EXPECT_EQ(graph_of(parse_map(".\n.\n", "m.map"), "0,0,N").stations.size(), 2u);
}

TEST(TrueGraph, ALineFromAJunctionToItselfTakesTwoSlots) {
  const TrueGraph graph = graph_of(parse_map("....\n.__.\n....\n.___\n.___\n", "m.map"), "0,4");
  EXPECT_EQ(slots(graph), "(1) 1:2 1:1");
  EXPECT_EQ(graph.junctions[0].arms[1].length, 10);
  EXPECT_EQ(line_count(graph), 2u);
}

TEST(TrueGraph, ABlockedLineNamesItsObstacleAndHowFarItCanBeFollowed) {
  const TrueGraph graph =
      graph_of(parse_map("__.____\n__.____\n....2..\n__x____\n__.____\n", "m.map"), "0,2");
  EXPECT_EQ(slots(graph), "(1) x x (2)");
  EXPECT_EQ(graph.junctions[0].arms[1].obstacle, (CellAt{2, 3}));
  EXPECT_EQ(graph.junctions[0].arms[1].length, 0);
  EXPECT_EQ(graph.junctions[0].arms[2].obstacle, (CellAt{4, 2}));
  EXPECT_EQ(graph.junctions[0].arms[2].length, 1);
  EXPECT_THAT(graph.unreachable, ElementsAre(CellAt{6, 2}, CellAt{2, 4}));
}

TEST(TrueGraph, WithoutAnyNodeIsEmpty) {
  EXPECT_EQ(graph_of(parse_map("...\n._.\n...\n", "m.map"), "0,1"), TrueGraph{});
  const TrueGraph cut = graph_of(parse_map("_x..x_\n_x__x_\n", "m.map"), "2,0");
  EXPECT_THAT(cut.stations, IsEmpty());
  EXPECT_EQ(line_count(cut), 0u);
}

TEST(TrueGraph, OfASingleCellIsOneStationWithNothingBehind) {
  const TrueGraph graph = graph_of(parse_map("___\n_.2\n___\n", "m.map"), "1,1");
  ASSERT_EQ(graph.stations.size(), 1u);
  EXPECT_EQ(graph.stations[0].arm.behind, Behind::nothing);
  EXPECT_EQ(distances_from(graph, 1), std::vector<int>{0});
}

TEST(TrueGraph, OfEachSampleAgreesWithWhatMapShowNumbers) {
  for (const char* name : {"a", "b", "c", "d", "e", "f", "warehouse", "city", "blocked", "island"}) {
    const Map map = read_map(find_map(name));
    const TrueGraph graph = true_graph(map, default_start(map));
    const Network network = trace_network(map, default_start(map));
    ASSERT_EQ(graph.stations.size(), network.stations.size()) << name;
    ASSERT_EQ(graph.junctions.size(), network.junctions.size()) << name;
    EXPECT_EQ(graph.unreachable, network.unreachable) << name;
  }
}

TEST(TrueGraph, OfWarehouseAndCityHasTheirCycles) {
  const Map warehouse = read_map(find_map("warehouse"));
  EXPECT_EQ(cycle_count(true_graph(warehouse, default_start(warehouse))), 4u);
  const Map city = read_map(find_map("city"));
  EXPECT_EQ(cycle_count(true_graph(city, default_start(city))), 16u);
}

TEST(TrueGraph, OfBlockedHasADetourRoundTheObstacle) {
  const Map map = read_map(find_map("blocked"));
  const TrueGraph graph = true_graph(map, default_start(map));
  EXPECT_EQ(slots(graph), "(1) x 2:0, 1:2 3:0 (3), 2:1 x (2)");
  EXPECT_EQ(graph.junctions[0].arms[1].obstacle, (CellAt{16, 14}));
  EXPECT_EQ(graph.junctions[0].arms[1].length, 6);
  EXPECT_EQ(distances_from(graph, 1), (std::vector<int>{0, 36, 22}));
  EXPECT_EQ(cycle_count(graph), 0u);
  EXPECT_EQ(line_count(graph), 7u);
}

// Returns the number of moves from one cell to each other cell, by breadth-first search over cells. This is
// the reference for distances_from().
std::vector<int> moves_from(const Map& map, CellAt from) {
  std::vector<int> moves(map.cells.size(), -1);
  std::queue<CellAt> queue;
  moves[map.index_of(from)] = 0;
  for (queue.push(from); !queue.empty(); queue.pop())
    for (int d = 0; d < 4; ++d) {
      const CellAt to = ahead(queue.front(), static_cast<Direction>(d));
      if (!is_line(map.at(to)) || map.at(to) == Cell::obstacle || moves[map.index_of(to)] >= 0) continue;
      moves[map.index_of(to)] = moves[map.index_of(queue.front())] + 1;
      queue.push(to);
    }
  return moves;
}

Map random_map(std::uint64_t seed) {
  const NoiseStream noise(seed, 0, "map", "true graph test");
  Map map;
  map.width = 2 + static_cast<int>(noise.bits(0) % 16);
  map.height = 2 + static_cast<int>(noise.bits(1) % 16);
  const double line = 0.2 + 0.7 * noise.uniform(2);
  const double wall = 0.2 * noise.uniform(3);
  for (int i = 0; i < map.width * map.height; ++i) {
    const double u = noise.uniform(static_cast<std::uint64_t>(i) + 4);
    map.cells.push_back(u < line                 ? Cell::line
                        : u < line + wall        ? Cell::wall
                        : u < line + wall + 0.03 ? Cell::obstacle
                                                 : Cell::floor);
  }
  map.cells[0] = Cell::line;
  return map;
}

void expect_consistent(const TrueGraph& graph) {
  const auto behind = [&](const Arm& arm) -> const Arm& {
    const auto i = static_cast<std::size_t>(arm.id - 1);
    return arm.behind == Behind::station ? graph.stations.at(i).arm
                                         : graph.junctions.at(i).arms.at(static_cast<std::size_t>(arm.slot));
  };
  const auto check = [&](Behind kind, int id, int slot, const Arm& arm) {
    ASSERT_NE(arm.behind, Behind::nothing);
    if (arm.behind == Behind::blocked) return;
    const Arm& back = behind(arm);
    EXPECT_EQ(back.behind, kind);
    EXPECT_EQ(back.id, id);
    EXPECT_EQ(back.slot, slot);
    EXPECT_EQ(back.length, arm.length);
  };
  for (std::size_t i = 0; i < graph.stations.size(); ++i)
    if (graph.stations.size() + graph.junctions.size() > 1)
      check(Behind::station, static_cast<int>(i) + 1, 0, graph.stations[i].arm);
  for (std::size_t i = 0; i < graph.junctions.size(); ++i)
    for (std::size_t slot = 0; slot < graph.junctions[i].arms.size(); ++slot)
      check(Behind::junction, static_cast<int>(i) + 1, static_cast<int>(slot), graph.junctions[i].arms[slot]);
}

TEST(TrueGraph, OfAnyMapFromAnyStartIsConsistentNumberedAsMapShowDoesAndTrueInItsDistances) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Map map = random_map(seed);
    std::vector<CellAt> cells;
    for (std::size_t i = 0; i < map.cells.size(); ++i)
      if (map.cells[i] == Cell::line) cells.push_back(map.cell_at(i));
    const std::uint64_t pick = NoiseStream(seed, 0, "start", "true graph test").bits(0);
    const Start start{cells[(pick >> 8) % cells.size()], static_cast<Direction>(pick & 3)};

    const TrueGraph graph = true_graph(map, start);
    const Network network = trace_network(map, start);
    ASSERT_EQ(graph.stations.size(), network.stations.size());
    for (std::size_t i = 0; i < graph.stations.size(); ++i)
      EXPECT_EQ(graph.stations[i].cell, network.stations[i].cell);
    ASSERT_EQ(graph.junctions.size(), network.junctions.size());
    for (std::size_t i = 0; i < graph.junctions.size(); ++i)
      EXPECT_EQ(graph.junctions[i].cell, network.junctions[i]);
    EXPECT_EQ(graph.unreachable, network.unreachable);
    expect_consistent(graph);
    if (graph.stations.empty()) continue;
    const std::vector<int> moves = moves_from(map, graph.stations[0].cell);
    const std::vector<int> distances = distances_from(graph, 1);
    for (std::size_t i = 0; i < graph.stations.size(); ++i)
      EXPECT_EQ(distances[i], moves[map.index_of(graph.stations[i].cell)]);
  }
}

TEST(TrueGraphDifference, IgnoresNumbersAndSlots) {
  const Map map = read_map(find_map("warehouse"));
  const TrueGraph one = true_graph(map, default_start(map));
  const TrueGraph other = true_graph(map, parse_start(map, "20,24"));
  EXPECT_NE(one, other);
  EXPECT_EQ(difference(one, other), "");
}

TEST(TrueGraphDifference, NamesWhatIsWrong) {
  const TrueGraph right = graph_of(parse_map(kRing, "m.map"), "4,5");
  TrueGraph wrong = right;
  wrong.stations.pop_back();
  EXPECT_EQ(difference(right, wrong), "station at 7,0 is missing");
  EXPECT_EQ(difference(wrong, right), "there is no station at 7,0");
  wrong = right;
  wrong.junctions.push_back(wrong.junctions[1]);
  EXPECT_EQ(difference(right, wrong), "the junction at 7,1 was found more than once");
  wrong = right;
  wrong.junctions[1].arms[2].length = 12;
  EXPECT_THAT(difference(right, wrong),
              HasSubstr("the line from 7,1 to the W leads to the junction at 4,3 in 11"));
  wrong = right;
  wrong.unreachable.push_back({1, 1});
  EXPECT_EQ(difference(right, wrong), "there is no unreachable station at 1,1");
}

TEST(TrueGraph, OfAMapThatIsAllLineIsRefused) {
  std::string rows = "S" + std::string(999, '1') + "\n";
  for (int row = 1; row < 1000; ++row) rows += std::string(1000, '1') + "\n";
  const Map map = parse_map(rows, "full.map");
  EXPECT_THAT(
      [&] { true_graph(map, default_start(map)); },
      testing::ThrowsMessage<InputError>(
          "full.map: the line has too many stations and junctions for a graph: expected at most 225000 "
          "(100000 and one for each 8 cells, but no more than 300000)"));
}

TEST(TrueGraph, OfALargeMapHasNoMoreNodesThanTheirTextFitsIntoMemory) {
  std::string rows = "S" + std::string(1999, '1') + "\n";
  for (int row = 1; row < 2000; ++row) rows += std::string(2000, row < 200 ? '1' : '0') + "\n";
  const Map map = parse_map(rows, "large.map");
  EXPECT_THAT([&] { true_graph(map, default_start(map)); },
              testing::ThrowsMessage<InputError>(HasSubstr("expected at most 300000 (")));
}

}  // namespace robosim::map::true_graph_test
