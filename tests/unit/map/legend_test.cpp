// Tests surfaces in a map's legend: the cells to which the surfaces apply, writing and reading legends, and
// invalid legends.
#include "sim/map/legend.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "sim/base/noise.h"
#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "tests/support/refusal.h"

namespace robosim::map::legend_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Returns the grip and the rolling resistance of each cell. The pair 0, 0 stands for the normal floor.
std::vector<std::pair<double, double>> surfaces_of(const Map& map) {
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const std::uint8_t which = map.surface_at(i);
    const SurfaceFigures one = which ? map.legend_surfaces.at(which - 1u) : SurfaceFigures{0.0, 0.0};
    all.emplace_back(one.grip, one.rolling);
  }
  return all;
}

constexpr const char* kLegend =
    "+++\n[legend]\n3 = \"gap\"\n4 = \"wet\"\n5 = \"wet line\"\n6 = \"carpet gap\"\n7 = \"dusty obstacle\"\n"
    "8 = { cell = \"line\", grip = \"40 %\", rolling = 0.03 }\n9 = { kind = \"carpet\" }\n+++\n";

TEST(ALegend, SaysWhatTheFloorOfACellIsMadeOf) {
  const Map map = parse_map(kLegend + std::string("____\nS5.3\n4678\n9___\n"), "m.map");
  EXPECT_THAT(map.cells,
              ElementsAre(Cell::floor, Cell::floor, Cell::floor, Cell::floor, Cell::line, Cell::line,
                          Cell::line, Cell::gap, Cell::floor, Cell::gap, Cell::obstacle, Cell::line,
                          Cell::floor, Cell::floor, Cell::floor, Cell::floor));
  using P = std::pair<double, double>;
  const P none{0.0, 0.0}, wet{0.6, 0.0}, carpet{1.0, 0.05}, dusty{0.5, 0.0}, own{0.4, 0.03};
  EXPECT_THAT(surfaces_of(map), ElementsAre(none, none, none, none, none, wet, none, none, wet, carpet, dusty,
                                            own, carpet, none, none, none));
}

TEST(ALegend, ThatNamesNoSurfaceMakesNone) {
  EXPECT_TRUE(parse_map("+++\n[legend]\n3 = \"gap\"\n+++\n1311\n", "m.map").surface_of_cell.empty());
  EXPECT_TRUE(parse_map("0121\n", "m.map").surface_of_cell.empty());
}

TEST(ALegend, DrawsItsSpreadsByTheSeed) {
  const std::string text = "+++\n[legend]\n4 = { grip = { value = 0.5, spread = 0.1 } }\n+++\n14\n";
  const auto grip = [&](Draw draw) { return parse_map(text, "m.map", "", draw).legend_surfaces.at(0).grip; };
  EXPECT_EQ(grip({7, Profile::ideal}), 0.5);
  const double drawn = grip({7, Profile::typical});
  EXPECT_NE(drawn, grip({8, Profile::typical}));
  EXPECT_NEAR(drawn, 0.5, 0.1);
}

// The start and the goal are on cells with surfaces. The characters S and G cannot describe these surfaces.
TEST(ALegend, IsReadBackAsItWasWritten) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const NoiseStream noise(seed, 0, "map", "legend");
    std::uint64_t n = 0;
    const auto pick = [&](std::string_view of) { return of[noise.bits(n++) % of.size()]; };
    std::string rows = "5_5_5_5\n";
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) rows += pick(seed % 2 ? "_.#x3456789" : "_.56");
      rows += '\n';
    }
    std::string text = kLegend;
    text.insert(4, "[start]\nx = 0\ny = 0\n[goal]\nx = 4\ny = 0\n");
    const Map map = parse_map(text + rows, "m.map");
    const std::string written = write_map(map);
    SCOPED_TRACE(written);
    const Map again = parse_map(written, "m.map");
    EXPECT_EQ(again.cells, map.cells);
    EXPECT_EQ(surfaces_of(again), surfaces_of(map));
    EXPECT_EQ(again.start->cell, map.start->cell);
    EXPECT_EQ(again.goal_cell, map.goal_cell);
    EXPECT_EQ(write_map(again), written);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ALegend, KeepsAFloorWithoutLinesButWithSurfacesAsRows) {
  const Map map = parse_map(
      "+++\n[[path]]\nfrom = [\"50 mm\", \"50 mm\"]\nsegments = [{ length = \"200 mm\" }]\n"
      "[legend]\n4 = \"carpet\"\n+++\n_4_\n",
      "m.map");
  EXPECT_EQ(surfaces_of(parse_map(write_map(map), "m.map")), surfaces_of(map));
}

TEST(ALegend, HasSevenDigits) {
  Map map = parse_map("________\n", "m.map");
  for (std::size_t i = 0; i < 8; ++i) {
    map.legend_surfaces.push_back({0.1 + 0.1 * static_cast<double>(i), 0.0});
    map.surface_of_cell.push_back(static_cast<std::uint8_t>(i + 1));
  }
  EXPECT_THROW(write_map(map), std::invalid_argument);
}

TEST(ALegend, ThatMakesNoSenseIsRefusedWithPlaceAndReason) {
  const struct {
    std::string line;
    const char* message;
  } refused[] = {
      {"4 = \"wte\"",
       "m.map:3:5: 4: expected a cell (floor, line, wall, gap or obstacle), a surface of the floor "
       "(wet, dusty or carpet), or a surface and a cell, as in \"wet line\""},
      {"4 = \"line wet\"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"wet  line\"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"wet carpet\"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"Wet line\"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"wet \"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"\"", "m.map:3:5: 4: expected a cell"},
      {"4 = \"wet wall\"", "m.map:3:5: 4: a wall has no surface, because nothing drives on it"},
      {"4 = { cell = \"wall\", kind = \"wet\" }", "4: a wall has no surface"},
      {"4 = { cell = \"hole\", kind = \"wet\" }",
       "m.map:3:14: cell: expected floor, line, gap "
       "or obstacle"},
      {"4 = { cell = 3, kind = \"wet\" }", "m.map:3:14: cell: expected a string"},
      {"4 = { cell = \"line\" }",
       "invalid surface: expected either a kind, as in kind = \"carpet\", or values"},
      {"4 = { kind = \"wet\", grip = 0.5 }", "invalid surface: expected either a kind"},
      {"4 = { kind = \"ice\" }", "kind: expected wet, dusty or carpet"},
      {"4 = { grip = 0 }", "m.map:3:14: grip: expected"},
      {"4 = { grip = \"3 mm\" }", "m.map:3:14: grip: expected"},
      {"4 = { rolling = 0.9 }", "m.map:3:17: rolling: expected"},
      {"4 = { grp = 0.5 }", "unknown key grp in 4 of [legend]; did you mean grip?"},
      {"4 = { grip = 0.5, colour = \"red\" }", "unknown key colour in 4 of [legend]"},
      {"4 = 5", "m.map:3:5: 4: expected words, such as \"wet line\", or a table"},
      {"4 = [\"wet\"]", "m.map:3:5: 4: expected words"},
      {"1 = \"wet\"", "m.map:3:5: [legend]: expected keys from 3 to 9, got `1`"},
      {"wet = \"4\"", "m.map:3:7: [legend]: expected keys from 3 to 9, got `wet`"},
      {"5 = \"wet\"", "m.map:5:2: unexpected character: expected"},
  };
  for (const auto& one : refused) {
    EXPECT_THAT(test::refusal([&] { parse_map("+++\n[legend]\n" + one.line + "\n+++\n14\n", "m.map"); }),
                testing::AllOf(HasSubstr(one.message), HasSubstr("m.map:")))
        << one.line;
  }
}

}  // namespace robosim::map::legend_test
