// The maps of maps/: that each reads, and is what its name promises.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/grid/map.h"
#include "sim/grid/network.h"
#include "sim/grid/stripes.h"

namespace robosim::grid {
namespace {

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

TEST(SampleMaps, AllOfThemReadAndNothingOnThemIsOutOfReach) {
  const std::vector<std::string> names = sample_names();
  for (const char* name : {"d", "dashed", "figure8", "oval", "tight"}) EXPECT_THAT(names, Contains(name));
  for (const std::string& name : names) {
    const Map map = sample(name);
    EXPECT_EQ(map.name, name);
    EXPECT_THAT(network_of(map).unreachable, IsEmpty()) << name;
    EXPECT_THAT(tight_bends(map), IsEmpty()) << name;
  }
}

// Stock robots fit a circle of 120 mm radius about the axle's centre.
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

// The facts of the paper's map d: L = 68, 7 stations, 5 forks of three ways, and v1's scan time
// T = 2(L-1) + S + 2W + W0 = 141 from every start, W and W0 counting the stations that face a wall.
TEST(SampleMaps, DHasTheFactsOfThePapersMapD) {
  const Map map = sample("d");
  const std::vector<CellAt> cells = line_cells(map);
  EXPECT_EQ(cells.size(), 68u);
  int facing_wall = 0;
  for (const Station& station : network_of(map).stations) {
    const unsigned lines = line_neighbours(map, station.cell);
    ASSERT_EQ(std::popcount(lines), 1);
    const Direction out = reversed(static_cast<Direction>(std::countr_zero(lines)));
    if (map.at(ahead(station.cell, out)) == Cell::wall) ++facing_wall;
  }
  const Network network = network_of(map);
  EXPECT_EQ(network.stations.size(), 7u);
  EXPECT_EQ(network.junctions.size(), 5u);
  for (const CellAt junction : network.junctions) EXPECT_EQ(std::popcount(line_neighbours(map, junction)), 3);
  EXPECT_THAT(network.loop, IsEmpty());
  EXPECT_EQ(facing_wall, 0);
  EXPECT_EQ(2 * (cells.size() - 1) + network.stations.size(), 141u);
}

}  // namespace
}  // namespace robosim::grid
