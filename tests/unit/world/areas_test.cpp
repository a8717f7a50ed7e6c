// Tests how the floor reflects light where a map has coloured areas.
#include <gtest/gtest.h>

#include "sim/world/floor.h"

namespace robosim::world::areas_test {

// Returns a map with a 20 mm line from left to right at y = 500 mm.
map::Map map_with_areas(const std::string& tables, const char* paint = "black on white") {
  return map::parse_map(
      std::string("+++\nsize = [\"2 m\", \"1 m\"]\nline = \"20 mm\"\npaint = \"") + paint + "\"\n" + tables +
          "\n[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"1 m\" }]\n+++\n",
      "m.map");
}

constexpr double kSpot = 0.002;

TEST(Areas, LieUnderTheLineAndInTheirOrderUnlessTheySayTheyLieOverIt) {
  const map::Map map = map_with_areas(R"(
area = [
  { colour = "green", at = ["500 mm", "500 mm"], size = ["100 mm", "100 mm"] },
  { colour = "white", at = ["530 mm", "500 mm"], radius = "10 mm" },
  { colour = "silver", at = ["800 mm", "500 mm"], size = ["25 mm", "250 mm"], over_lines = true },
])");
  const Floor floor(map);
  const auto back = [&](double x, double y) { return 1.0 - floor.darkness({x, y}, kSpot); };
  EXPECT_NEAR(back(0.3, 0.4), 1.0, 1e-12);     // paper
  EXPECT_NEAR(back(0.48, 0.5), 0.0, 1e-12);    // the line over the green
  EXPECT_NEAR(back(0.48, 0.53), 0.65, 1e-12);  // green
  EXPECT_NEAR(back(0.48, 0.55), 0.825, 1e-9);  // the edge of the green
  EXPECT_NEAR(back(0.53, 0.5), 0.0, 1e-12);    // the line over both areas
  EXPECT_NEAR(back(0.8, 0.5), 1.25, 1e-12);    // the silver over the line
  EXPECT_NEAR(back(0.8, 0.6), 1.25, 1e-12);
  // Areas do not change the coverage by the line.
  EXPECT_EQ(floor.on_line({0.8, 0.5}, kSpot), 1.0);
  EXPECT_EQ(floor.on_line({0.48, 0.53}, kSpot), 0.0);
}

TEST(Areas, HaveAColourForWhoeverTellsColoursApart) {
  const map::Map map = map_with_areas(R"(
area = [
  { colour = "green", at = ["500 mm", "600 mm"], size = ["100 mm", "100 mm"] },
  { colour = "red", at = ["800 mm", "600 mm"], size = ["100 mm", "100 mm"] },
])");
  const Floor floor(map);
  const Vec2 green{0.5, 0.6}, red{0.8, 0.6}, paper{1.0, 0.8};
  EXPECT_LT(floor.darkness(green, kSpot, Band::green), floor.darkness(green, kSpot, Band::red) - 0.2);
  EXPECT_LT(floor.darkness(red, kSpot, Band::red), floor.darkness(red, kSpot, Band::green) - 0.2);
  EXPECT_EQ(floor.darkness(paper, kSpot, Band::blue), 0.0);
  // Both colours look bright in infrared.
  EXPECT_LT(floor.darkness(green, kSpot), 0.5);
  EXPECT_LT(floor.darkness(red, kSpot), 0.5);
}

TEST(Areas, AreSharesOfAFootprintAtTheirEdges) {
  const map::Map map = map_with_areas(R"(
area = [{ colour = "white", at = ["500 mm", "800 mm"], radius = "50 mm" }])",
                                      "white on black");
  const Floor floor(map);
  EXPECT_NEAR(floor.darkness({0.5, 0.8}, 0.01), 0.0, 1e-12);
  EXPECT_NEAR(floor.darkness({0.55, 0.8}, 0.01), 0.5, 1e-9);
  EXPECT_NEAR(floor.darkness({0.5525, 0.8}, 0.01), 0.75, 1e-9);
  EXPECT_NEAR(floor.darkness({0.556, 0.8}, 0.01), 1.0, 1e-12);
}

}  // namespace robosim::world::areas_test
