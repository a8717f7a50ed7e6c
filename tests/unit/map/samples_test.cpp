// Tests that each map in `maps/` can be read, and has the features that its name promises.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/map/map.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"

namespace robosim::map::samples_test {

using ::testing::Contains;
using ::testing::IsEmpty;

std::vector<std::string> sample_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "maps"))
    if (entry.path().extension() == ".map") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Map sample(const std::string& name) { return read_map(find_map(name)); }

Network network_of(const Map& map) { return trace_network(map, default_start(map)); }

std::vector<CellAt> line_cells(const Map& map) {
  std::vector<CellAt> cells;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (is_line(map.cells[i])) cells.push_back(map.cell_at(i));
  return cells;
}

TEST(SampleMaps, AllOfThemReadAndOnlyTheIslandIsOutOfReach) {
  const std::vector<std::string> names = sample_names();
  for (const char* name : {"a", "b", "blocked", "c", "city", "d", "dashed", "e", "f", "figure8", "island",
                           "oval", "tight", "warehouse"})
    EXPECT_THAT(names, Contains(name));
  for (const std::string& name : names) {
    const Map map = sample(name);
    EXPECT_EQ(map.name, name);
    EXPECT_EQ(network_of(map).unreachable.size(), name == "island" ? 1u : 0u) << name;
    EXPECT_THAT(tight_bends(map), IsEmpty()) << name;
  }
}

// Stock robots fit into a circle of 120 mm radius around the axle's centre.
TEST(SampleMaps, ARobotOnTheLineTouchesNoWall) {
  constexpr double kRobot = 0.120;
  for (const std::string& name : sample_names()) {
    const Map map = sample(name);
    const int around = static_cast<int>(kRobot / map.cell_m) + 1;
    for (const CellAt cell : line_cells(map))
      for (int dy = -around; dy <= around; ++dy)
        for (int dx = -around; dx <= around; ++dx) {
          if (map.at({cell.x + dx, cell.y + dy}) != Cell::wall) continue;
          const double x = std::max(std::abs(dx) - 0.5, 0.0) * map.cell_m;
          const double y = std::max(std::abs(dy) - 0.5, 0.0) * map.cell_m;
          EXPECT_GE(length({x, y}), kRobot) << name << ' ' << cell.x << ',' << cell.y;
        }
  }
}

TEST(SampleMaps, OvalFigure8TightAndDashedAreLoops) {
  for (const char* name : {"oval", "figure8", "tight", "dashed"}) {
    const Map map = sample(name);
    EXPECT_FALSE(network_of(map).loop.empty()) << name;
    EXPECT_EQ(map.goal, "laps:1") << name;
  }
  EXPECT_EQ(network_of(sample("figure8")).junctions.size(), 1u);
}

TEST(SampleMaps, OvalHasBendsOfAtLeast200Millimetres) { EXPECT_GE(sample("oval").corner_m, 0.2); }

TEST(SampleMaps, TightHasBendsOf75To100Millimetres) {
  const Map map = sample("tight");
  const Stripes stripes(map, 0.1);
  for (const Stripe& stripe : stripes.all())
    if (stripe.radius > 0.0) {
      EXPECT_GE(stripe.radius, 0.075);
      EXPECT_LE(stripe.radius, 0.100);
    }
}

TEST(SampleMaps, DashedHasGapsOf25To50Millimetres) {
  const Map map = sample("dashed");
  int gaps = 0;
  const Stripes stripes(map, 0.1);
  for (const Stripe& stripe : stripes.all()) {
    if (stripe.painted) continue;
    const double gap = length(stripe.b - stripe.a) - map.line_m;
    EXPECT_GE(gap, 0.025 - 1e-9);
    EXPECT_LE(gap, 0.050 + 1e-9);
    ++gaps;
  }
  EXPECT_GE(gaps, 10);
}

// Properties of a map in `maps/`. docs/reference/maps.md lists some of these properties.
struct Facts {
  const char* name;
  std::size_t line_cells;
  std::size_t stations;  ///< number of reachable stations
  std::size_t junctions;
  std::size_t crossings;  ///< four-way junctions
  std::size_t cycles;     ///< independent cycles of the map's line
};

void PrintTo(const Facts& facts, std::ostream* out) { *out << facts.name; }

class Sample : public testing::TestWithParam<Facts> {};

TEST_P(Sample, HasTheFactsOfTheDocumentation) {
  const Map map = sample(GetParam().name);
  const std::vector<CellAt> cells = line_cells(map);
  const Network network = network_of(map);
  EXPECT_EQ(cells.size(), GetParam().line_cells);
  EXPECT_EQ(network.stations.size(), GetParam().stations);
  EXPECT_EQ(network.junctions.size(), GetParam().junctions);
  EXPECT_EQ(std::count_if(network.junctions.begin(), network.junctions.end(),
                          [&](CellAt cell) { return line_neighbours(map, cell) == 15; }),
            GetParam().crossings);
  std::size_t ends = 0;
  for (const CellAt cell : cells) ends += static_cast<std::size_t>(std::popcount(line_neighbours(map, cell)));
  const std::size_t pieces = std::string_view(GetParam().name) == "island" ? 2 : 1;
  EXPECT_EQ(ends / 2 + pieces - cells.size(), GetParam().cycles);
}

// A robot with motors needs space around a line, and before a landmark: an end, a bend or a junction.
TEST_P(Sample, LeavesThreeCellsBetweenLandmarksAndAroundLines) {
  const Map map = sample(GetParam().name);
  for (const CellAt cell : line_cells(map)) {
    const unsigned lines = line_neighbours(map, cell);
    for (const Direction d : {Direction::east, Direction::south, Direction::west, Direction::north}) {
      for (int n = 1; n <= 2; ++n) {
        CellAt at = cell;
        for (int i = 0; i < n; ++i) at = ahead(at, d);
        EXPECT_NE(map.at(at), Cell::wall) << cell.x << ',' << cell.y;
        EXPECT_TRUE(has(lines, d) || !is_line(map.at(at))) << cell.x << ',' << cell.y;
        const bool landmark = lines != 5 && lines != 10;
        if (!has(lines, d) || !landmark) continue;
        const unsigned there = line_neighbours(map, at);
        EXPECT_TRUE(there == 5 || there == 10) << at.x << ',' << at.y;
        EXPECT_NE(map.at(at), Cell::obstacle);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Sample,
                         testing::Values(Facts{"a", 24, 2, 0, 0, 0}, Facts{"b", 35, 4, 2, 0, 0},
                                         Facts{"c", 45, 6, 4, 0, 0}, Facts{"d", 68, 7, 5, 0, 0},
                                         Facts{"e", 62, 7, 5, 0, 0}, Facts{"f", 116, 17, 15, 0, 0},
                                         Facts{"warehouse", 111, 5, 11, 0, 4},
                                         Facts{"city", 173, 6, 25, 11, 16}, Facts{"blocked", 54, 3, 3, 0, 1},
                                         Facts{"island", 48, 4, 2, 0, 1}),
                         [](const auto& test) { return std::string(test.param.name); });

// Expects the scan times of the Robosim paper (docs/howto/research.md). Robosim v1's formula for trees of
// three-way forks is T = 2(L-1) + S + 2W + W0. L is the number of line cells, and S is the number of
// stations. W and W0 count stations at a wall. These maps have no stations at a wall.
TEST(SampleMaps, CToFTakeTheScanTimesOfThePaper) {
  const std::pair<const char*, std::size_t> times[] = {{"c", 94}, {"d", 141}, {"e", 129}, {"f", 247}};
  for (const auto& [name, time] : times) {
    const Map map = sample(name);
    const Network network = network_of(map);
    for (const Station& station : network.stations) {
      const Direction out = reversed(default_facing(map, station.cell));
      EXPECT_EQ(map.at(ahead(station.cell, out)), Cell::floor) << name << ' ' << station.id;
    }
    EXPECT_EQ(2 * (line_cells(map).size() - 1) + network.stations.size(), time) << name;
    EXPECT_EQ(network.stations[0].cell, default_start(map).cell) << name;
  }
}

// An obstacle blocks the direct route of 24 cells from the first station to the second. If bare floor
// replaces the obstacle, the direct route has a gap, but all stations stay reachable.
TEST(SampleMaps, BlockedHasADetour) {
  Map map = sample("blocked");
  const auto obstacle = std::find(map.cells.begin(), map.cells.end(), Cell::obstacle);
  ASSERT_NE(obstacle, map.cells.end());
  *obstacle = Cell::floor;
  EXPECT_EQ(network_of(map).stations.size(), 5u);  // the two new line ends, and all three stations
}

}  // namespace robosim::map::samples_test
