#include "sim/map/map_writer.h"

#include <gtest/gtest.h>

#include "sim/base/noise.h"

namespace robosim::map::map_writer_test {

// Expects that both maps are equal in everything that affects a driving robot.
void expect_same(const Map& a, const Map& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.cell_m, b.cell_m);
  EXPECT_EQ(a.line_m, b.line_m);
  EXPECT_EQ(a.corner_m, b.corner_m);
  EXPECT_EQ(a.raster, b.raster);
  ASSERT_EQ(a.start.has_value(), b.start.has_value());
  if (a.start) {
    EXPECT_EQ(a.start->cell, b.start->cell);
    EXPECT_EQ(a.start->facing, b.start->facing);
  }
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_EQ(a.goal_cell, b.goal_cell);
  ASSERT_EQ(a.stations.size(), b.stations.size());
  EXPECT_EQ(a.generator, b.generator);
}

TEST(WriteMap, WritesPlainMapsPlainly) {
  Map map = parse_map("202\n111\n", "m.map");
  map.name.clear();
  EXPECT_EQ(write_map(map), "#_#\n...\n");
}

// Writing any map and reading it again gives an equal map.
TEST(WriteMap, IsReadBackAsTheSameMap) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const NoiseStream noise(seed, 0, "map", "test");
    std::uint64_t n = 0;
    const auto below = [&](int most) {
      return static_cast<int>(noise.bits(n++) % static_cast<std::uint64_t>(most));
    };
    Map map;
    map.name = "m\"\\\n\x7F";
    map.width = 1 + below(12);
    map.height = 1 + below(12);
    const int kinds = seed % 2 ? 5 : 3;
    std::vector<CellAt> lines;
    for (CellAt c; c.y < map.height; ++c.y)
      for (c.x = 0; c.x < map.width; ++c.x) {
        map.cells.push_back(static_cast<Cell>(below(kinds)));
        if (map.cells.back() == Cell::line || map.cells.back() == Cell::gap) lines.push_back(c);
      }
    map.cell_m = (1 + below(1000)) * 1e-3;
    map.line_m = map.cell_m / (1 + below(7));
    map.corner_m = below(2) ? below(300) * 1.1e-3 : 0.0;
    map.raster = below(2) != 0;
    if (below(2)) map.generator = "g 1";
    const auto some = [&] { return lines[static_cast<std::size_t>(below(static_cast<int>(lines.size())))]; };
    if (!lines.empty() && below(2)) map.start = Start{some(), static_cast<Direction>(below(4))};
    if (!lines.empty() && below(2)) map.stations.push_back({"dock", some()});
    if (below(2)) map.goal = "laps:2";
    if (!lines.empty() && below(2)) {
      const CellAt cell = some();
      const bool named = !map.stations.empty() && map.stations[0].cell == cell;
      if (!named) map.stations.push_back({"goal", cell});
      map.goal_cell = cell;
      if (map.goal.empty() || map.at(cell) == Cell::gap) map.goal = named ? "station:dock" : "station:goal";
    }
    const std::string text = write_map(map);
    SCOPED_TRACE(text);
    expect_same(parse_map(text, "m.map"), map);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace robosim::map::map_writer_test
