#include "sim/map/generator.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "sim/base/file.h"
#include "sim/map/map_writer.h"
#include "sim/map/true_graph.h"

namespace robosim::map::generator_test {

using ::testing::IsEmpty;

constexpr Family kAll[] = {Family::tree, Family::cycles, Family::grid};

TrueGraph graph_of(const Map& map) { return true_graph(map, default_start(map)); }

// Calls `visit` for maps of a family, with up to about 200 junctions. Each map has its own seed.
template <typename Visit>
void for_many(Family family, int maps, Visit visit) {
  const int most = family == Family::tree ? 202 : family == Family::cycles ? 100 : 60;
  for (int n = 0; n < maps; ++n) {
    const int stations = kMinStations + n * 7 % (most - 1);
    SCOPED_TRACE(generated_name(family, stations, static_cast<std::uint64_t>(n)));
    visit(stations, generate(family, stations, static_cast<std::uint64_t>(n)));
  }
}

// Returns the number of line cells of a graph that has no blocked lines: nodes, and cells between nodes.
std::size_t cells_of(const TrueGraph& graph) {
  std::size_t between = 0;  // twice the cells between nodes, because each line is counted at both ends
  for (const GraphStation& station : graph.stations)
    between += static_cast<std::size_t>(station.arm.length - 1);
  for (const GraphJunction& junction : graph.junctions)
    for (const Arm& arm : junction.arms) between += static_cast<std::size_t>(arm.length - 1);
  return graph.stations.size() + graph.junctions.size() + between / 2;
}

TEST(Generator, MakesAConnectedMapWithExactlyTheStationsItIsAskedFor) {
  for (const Family family : kAll)
    for_many(family, 334, [](int stations, const Map& map) {
      const TrueGraph graph = graph_of(map);
      EXPECT_EQ(graph.stations.size(), static_cast<std::size_t>(stations));
      EXPECT_THAT(graph.unreachable, IsEmpty());
      std::size_t line = 0;
      for (const Cell cell : map.cells) line += is_line(cell);
      EXPECT_EQ(cells_of(graph), line);
    });
}

TEST(Generator, MakesTreesOfJunctionsOfThreeWays) {
  for_many(Family::tree, 200, [](int stations, const Map& map) {
    const TrueGraph graph = graph_of(map);
    EXPECT_EQ(cycle_count(graph), 0u);
    EXPECT_EQ(graph.junctions.size(), static_cast<std::size_t>(stations - 2));
    for (const GraphJunction& junction : graph.junctions) EXPECT_EQ(junction.arms.size(), 3u);
  });
}

TEST(Generator, MakesCyclesAndCrossings) {
  for (const Family family : {Family::cycles, Family::grid}) {
    std::size_t crossings = 0;
    for_many(family, 100, [&](int, const Map& map) {
      const TrueGraph graph = graph_of(map);
      EXPECT_GE(cycle_count(graph), 1u);
      for (const GraphJunction& junction : graph.junctions) crossings += junction.arms.size() == 4;
    });
    EXPECT_GE(crossings, 100u) << name_of(family);
  }
}

TEST(Generator, LeavesThreeCellsBetweenLandmarksAndAroundLines) {
  for (const Family family : kAll)
    for_many(family, 30, [](int, const Map& map) {
      for (std::size_t i = 0; i < map.cells.size(); ++i) {
        if (!is_line(map.cells[i])) continue;
        const CellAt cell = map.cell_at(i);
        EXPECT_TRUE(cell.x >= 3 && cell.y >= 3 && cell.x < map.width - 3 && cell.y < map.height - 3);
        const unsigned lines = line_neighbours(map, cell);
        for (const Direction d : {Direction::east, Direction::south, Direction::west, Direction::north}) {
          const CellAt next = ahead(cell, d);
          const bool beyond = is_line(map.at(ahead(next, d)));
          EXPECT_TRUE(has(lines, d) || !beyond) << cell.x << ',' << cell.y;
          if (!has(lines, d) || lines == 5 || lines == 10) continue;
          for (const CellAt at : {next, ahead(next, d)}) {
            const unsigned there = line_neighbours(map, at);
            EXPECT_TRUE(there == 5 || there == 10) << at.x << ',' << at.y;
          }
        }
      }
    });
}

TEST(Generator, WritesMapsThatReadBackEqual) {
  for (const Family family : kAll)
    for_many(family, 20, [](int, const Map& map) {
      const Map read = parse_map(write_map(map), map.file);
      EXPECT_EQ(read.cells, map.cells);
      EXPECT_EQ(read.width, map.width);
      EXPECT_EQ(read.name, map.name);
      EXPECT_EQ(read.goal, "tour");
      EXPECT_EQ(read.generator, map.generator);
    });
}

TEST(Generator, NamesItselfWithVersionAndSeed) {
  EXPECT_EQ(generate(Family::cycles, 5, 42).generator, "cycles 1 stations 5 seed 42");
  EXPECT_EQ(generate(Family::cycles, 5, 42).name, "cycles-5-42");
}

// Equal arguments give equal bytes on every machine and with every compiler. If these bytes change, raise
// kGeneratorVersion.
TEST(Generator, MakesTheseVeryMaps) {
  const auto hash = [](Family family, int stations, std::uint64_t seed) {
    return sha256(write_map(generate(family, stations, seed))).substr(0, 16);
  };
  EXPECT_EQ(kGeneratorVersion, 1);
  EXPECT_EQ(hash(Family::tree, 2, 1), "f2106767bce0c1fc");
  EXPECT_EQ(hash(Family::tree, 1000, 7), "bc07362f1fc48cf9");
  EXPECT_EQ(hash(Family::cycles, 2, 1), "262439088121bcfc");
  EXPECT_EQ(hash(Family::cycles, 1000, 18446744073709551615u), "b27ade52eaf675be");
  EXPECT_EQ(hash(Family::grid, 2, 1), "79824b827e25aaef");
  EXPECT_EQ(hash(Family::grid, 1000, 7), "0afcb22b597e21f4");
}

TEST(Generator, GivesOtherMapsForOtherSeeds) {
  for (const Family family : kAll) {
    const Map map = generate(family, 20, 1);
    EXPECT_EQ(generate(family, 20, 1).cells, map.cells);
    EXPECT_NE(generate(family, 20, 2).cells, map.cells);
  }
}

TEST(Generator, NeedsLittleRoomForAStation) {
  for (const Family family : kAll) {
    const int stations = 20'000;
    EXPECT_LE(generate(family, stations, 1).cells.size(), std::size_t{75} * stations) << name_of(family);
  }
}

TEST(Generator, RefusesNumbersOfStationsBeyondItsLimits) {
  EXPECT_THROW(generate(Family::tree, kMinStations - 1, 1), std::invalid_argument);
  EXPECT_THROW(generate(Family::tree, kMaxStations + 1, 1), std::invalid_argument);
}

TEST(Generator, KnowsItsFamiliesByName) {
  for (const Family family : kAll) EXPECT_EQ(family_of(name_of(family)), family);
  EXPECT_EQ(family_of("forest"), std::nullopt);
}

}  // namespace robosim::map::generator_test
