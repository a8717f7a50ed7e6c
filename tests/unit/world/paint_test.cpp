// Tests lines whose segments have their own width, darkness or wear.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/floor.h"

namespace robosim::world::paint_test {

constexpr double kSeen = 0.002;

// Returns a map with a 20 mm line from left to right at y = 500 mm. The line consists of `pieces`.
map::Map map_of_pieces(const std::string& pieces, const std::string& top = "") {
  return map::parse_map("+++\nsize = [\"4 m\", \"1 m\"]\nline = \"20 mm\"\n" + top +
                            "\n[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [" + pieces + "]\n+++\n",
                        "m.map");
}

TEST(Paints, OfSegmentsAreAsWideAndAsDarkAsTheySay) {
  const map::Map map = map_of_pieces(
      "{ length = \"600 mm\" }, { length = \"600 mm\", width = \"8 mm\" }, { length = \"600 mm\", width = "
      "\"40 "
      "mm\", colour = \"grey 60 %\" }, { length = \"600 mm\", colour = \"red\", gloss = \"10 %\" }");
  const Floor floor(map);
  const auto dark = [&](double x, double away) { return floor.darkness({x, 0.5 + away}, kSeen); };
  EXPECT_NEAR(dark(0.5, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(dark(0.5, 0.010), 0.5, 1e-9);
  EXPECT_NEAR(dark(1.1, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(dark(1.1, 0.004), 0.5, 1e-9);
  EXPECT_NEAR(dark(1.1, 0.006), 0.0, 1e-12);
  EXPECT_NEAR(dark(1.7, 0.0), 0.6, 1e-12);
  EXPECT_NEAR(dark(1.7, 0.018), 0.6, 1e-12);
  EXPECT_NEAR(dark(1.7, 0.020), 0.3, 1e-9);
  EXPECT_NEAR(dark(2.3, 0.0), 0.25 - 0.10, 1e-12);
  EXPECT_NEAR(floor.darkness({2.3, 0.5}, kSeen, Band::green), 0.90 - 0.10, 1e-12);
  // There is no seam between pieces.
  for (double x = 0.79; x < 0.81; x += 0.001) EXPECT_NEAR(dark(x, 0.0), 1.0, 1e-12) << x;
  // The first footprint is wider than the line. The second footprint is also wider than kUsualFootprint of
  // floor.cpp. For it, the floor searches all stripes instead of those near the cell.
  EXPECT_NEAR(floor.darkness({1.1, 0.5}, 0.016), 0.5, 1e-9);
  EXPECT_NEAR(floor.darkness({1.1, 0.5}, 0.032), 0.25, 1e-9);
  // For on_line(), the line has the map's line width, or the segment's width if the segment is wider.
  EXPECT_EQ(floor.on_line({1.1, 0.506}, kSeen), 1.0);
  EXPECT_EQ(floor.on_line({0.5, 0.012}, kSeen), 0.0);
  EXPECT_EQ(floor.on_line({1.7, 0.518}, kSeen), 1.0);
  EXPECT_NEAR(floor.on_line({1.7, 0.520}, kSeen), 0.5, 1e-9);
  EXPECT_EQ(floor.on_line({1.7, 0.522}, kSeen), 0.0);
  EXPECT_NEAR(floor.on_line({1.7, 0.520}, 0.02), 0.5, 1e-9) << "the footprint exceeds the index's reach";
}

TEST(Paints, OfAWideSegmentAreTheLineThere) {
  const std::string cells = "_________\n_..._..._\n_________\n";
  const map::Map map = map::parse_map(
      "+++\nline = \"20 mm\"\n[[path]]\nfrom = [\"100 mm\", \"250 mm\"]\nwidth = \"60 mm\"\nsegments = [{ "
      "length = \"300 mm\" }, { length = \"100 mm\", gap = true }, { length = \"200 mm\" }]\n+++\n" +
          cells,
      "m.map");
  const Floor floor(map);
  EXPECT_EQ(floor.on_line({0.3, 0.275}, kSeen), 1.0);
  EXPECT_EQ(floor.on_line({0.45, 0.25}, kSeen), 0.0) << "a gap";
  EXPECT_EQ(floor.on_line({0.2, 0.15}, kSeen), 1.0) << "a line of cells";
  EXPECT_EQ(floor.on_line({0.2, 0.165}, kSeen), 0.0) << "lines of cells are not wider";
}

// The mean darkness along the line's middle, and the shares of points with complete paint and without paint.
struct Seen {
  double mean = 0.0, whole = 0.0, bare = 0.0;
};

Seen look_along(const Floor& floor, double from, double to) {
  Seen seen;
  double count = 0.0;
  for (double x = from; x < to; x += 0.0005, count += 1.0) {
    const double dark = floor.darkness({x, 0.5}, kSeen);
    seen.mean += dark;
    seen.whole += dark > 0.99;
    seen.bare += dark < 0.01;
  }
  return {seen.mean / count, seen.whole / count, seen.bare / count};
}

TEST(Paints, ThatAreWornHaveLostTheirShareInPatches) {
  for (const double worn : {0.2, 0.5, 0.8}) {
    const map::Map map = map_of_pieces("{ length = \"3.6 m\", worn = " + std::to_string(worn) + " }");
    double mean = 0.0, bare = 0.0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Floor floor(map);
      floor.wear(NoiseStream(seed, 0, "floor", "wear"));
      const Seen seen = look_along(floor, 0.3, 3.7);
      mean += seen.mean / 40.0;
      bare += seen.bare / 40.0;
    }
    EXPECT_NEAR(mean, 1.0 - worn, 0.01) << worn;
    EXPECT_GT(bare, 0.3 * worn * worn) << "in patches, not all over: " << worn;
  }
}

TEST(Paints, AreWornWhereTheSeedSaysAndNowhereElse) {
  const map::Map map = map_of_pieces("{ length = \"1.8 m\" }, { length = \"1.8 m\", worn = 0.5 }");
  Floor one(map), same(map), other(map);
  one.wear(NoiseStream(1, 0, "floor", "wear"));
  same.wear(NoiseStream(1, 0, "floor", "wear"));
  other.wear(NoiseStream(2, 0, "floor", "wear"));
  int differ = 0;
  for (double x = 0.3; x < 3.7; x += 0.01) {
    const double dark = one.darkness({x, 0.5}, kSeen);
    EXPECT_EQ(dark, same.darkness({x, 0.5}, kSeen));
    if (x < 1.98) {
      EXPECT_EQ(dark, 1.0) << x;
    }
    differ += std::fabs(dark - other.darkness({x, 0.5}, kSeen)) > 0.1;
    EXPECT_EQ(one.darkness({x, 0.7}, kSeen), 0.0) << "the floor beside it";
  }
  EXPECT_GT(differ, 40);
}

TEST(Paints, WearOfAMapIsThatOfCellsAndMarksToo) {
  const std::string rows = "__________\n__......__\n__________\n";
  map::Map map = map::parse_map("+++\nworn = 1\n+++\n" + rows, "m.map");
  EXPECT_EQ(Floor(map).darkness({0.5, 0.15}, kSeen), 0.0);
  map = map::parse_map("+++\nworn = 0\n+++\n" + rows, "m.map");
  EXPECT_EQ(Floor(map).darkness({0.5, 0.15}, kSeen), 1.0);

  const std::string mark = "[[mark]]\nalong = \"1 m\"\n";
  const auto with = [&](const std::string& top, const std::string& keys) {
    map::Map marked = map::parse_map("+++\nsize = [\"4 m\", \"1 m\"]\n" + top +
                                         "[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = "
                                         "\"2 m\" }]\n" +
                                         mark + keys + "\n+++\n",
                                     "m.map");
    return Floor(marked).darkness({1.2, 0.57}, kSeen);
  };
  EXPECT_EQ(with("", ""), 1.0);
  EXPECT_EQ(with("worn = 1\n", ""), 0.0);
  EXPECT_EQ(with("", "worn = 1"), 0.0);
  EXPECT_NEAR(with("", "colour = \"grey 30 %\""), 0.3, 1e-12);
}

TEST(Paints, GlossAddsToWhatAnyColourSendsBack) {
  for (const char* paint : {"black on white", "white on black"}) {
    const std::string top = std::string("paint = \"") + paint + "\"\n";
    const map::Map matt = map_of_pieces("{ length = \"3 m\" }", top);
    const map::Map glossy = map_of_pieces("{ length = \"3 m\" }", top + "gloss = \"5 %\"\n");
    const Floor a(matt), b(glossy);
    for (double away = 0.0; away < 0.02; away += 0.001)
      EXPECT_NEAR(b.darkness({1.0, 0.5 + away}, kSeen), a.darkness({1.0, 0.5 + away}, kSeen) - 0.05, 1e-12);
  }
  const map::Map area = map_of_pieces(
      "{ length = \"3 m\" }",
      "area = [{ colour = \"black\", at = [\"1 m\", \"800 mm\"], radius = \"50 mm\", gloss = 0.3 }]\n");
  EXPECT_NEAR(Floor(area).darkness({1.0, 0.8}, kSeen), 0.7, 1e-12);
  EXPECT_NEAR(Floor(area).darkness({1.0, 0.7}, kSeen), 0.0, 1e-12);
}

}  // namespace robosim::world::paint_test
