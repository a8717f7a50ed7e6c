#include "sim/map/stripes.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "sim/base/noise.h"

namespace robosim::map::stripes_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kReach = 0.15;
constexpr double kFar = std::numeric_limits<double>::infinity();

Map with_corner(const char* corner, const char* cells) {
  return parse_map(std::string("+++\ncorner = \"") + corner + "\"\n[legend]\n3 = \"gap\"\n+++\n" + cells,
                   "m.map");
}

double nearest(const Stripes& stripes, Vec2 p, bool painted_only = false) {
  double d = kFar;
  for (const Stripe& stripe : stripes.all())
    if (stripe.painted || !painted_only) d = std::min(d, distance(stripe, p));
  return d;
}

// Returns the length of the centre line, including its arcs.
double total_length(const Stripes& stripes) {
  double total = 0.0;
  for (const Stripe& s : stripes.all())
    total +=
        s.radius > 0.0 ? s.radius * 2.0 * std::asin(length(s.b - s.a) / 2.0 / s.radius) : length(s.b - s.a);
  return total;
}

TEST(Stripe, DistanceToASegmentIsToItsNearestPoint) {
  const Stripe s{{1, 2}, {4, 2}};
  EXPECT_DOUBLE_EQ(distance(s, {2, 5}), 3);
  EXPECT_DOUBLE_EQ(distance(s, {2, 1}), 1);
  EXPECT_DOUBLE_EQ(distance(s, {7, 6}), 5);
  EXPECT_DOUBLE_EQ(distance(s, {-2, -2}), 5);
  EXPECT_DOUBLE_EQ(distance(s, {3, 2}), 0);
}

TEST(Stripe, DistanceToAnArcIsToTheCircleWithinAndToAnEndBeyond) {
  const Stripe s{{1, 0}, {0, 1}, {0, 0}, 1.0};
  EXPECT_DOUBLE_EQ(distance(s, {3, 4}), 4);
  EXPECT_DOUBLE_EQ(distance(s, {0.3, 0.4}), 0.5);
  EXPECT_DOUBLE_EQ(distance(s, {0, 0}), 1);
  EXPECT_DOUBLE_EQ(distance(s, {1, -2}), 2);
  EXPECT_DOUBLE_EQ(distance(s, {-3, 1}), 3);
  EXPECT_DOUBLE_EQ(distance(s, {-3, -3}), 5);
}

TEST(Stripes, AStraightRunIsOneSegment) {
  const Map map = parse_map("_____\n_1111\n_____\n", "m.map");
  const Stripes stripes(map, kReach);
  ASSERT_EQ(stripes.all().size(), 1u);
  EXPECT_EQ(stripes.all()[0].a, map.centre({1, 1}));
  EXPECT_EQ(stripes.all()[0].b, map.centre({4, 1}));
}

TEST(Stripes, ASingleCellIsADot) {
  const Map map = parse_map("___\n_1_\n___\n", "m.map");
  const Stripes stripes(map, kReach);
  ASSERT_EQ(stripes.all().size(), 1u);
  EXPECT_DOUBLE_EQ(distance(stripes.all()[0], map.centre({1, 1})), 0.0);
}

TEST(Stripes, ACornerIsAQuarterCircleTangentToItsLegs) {
  const Map map = with_corner("200 mm",
                              "______\n"
                              "_1111_\n"
                              "_1____\n"
                              "_1____\n"
                              "_1____\n");
  const Stripes stripes(map, kReach);
  EXPECT_THAT(stripes.tight_bends(), IsEmpty());
  ASSERT_EQ(stripes.all().size(), 3u);
  const Vec2 bend = map.centre({1, 1});
  const auto arc =
      std::find_if(stripes.all().begin(), stripes.all().end(), [](const Stripe& s) { return s.radius > 0; });
  ASSERT_NE(arc, stripes.all().end());
  EXPECT_DOUBLE_EQ(arc->radius, 0.2);
  EXPECT_NEAR(length(arc->centre - (bend + Vec2{0.2, -0.2})), 0.0, 1e-12);
  EXPECT_NEAR(total_length(stripes), 0.1 + 0.1 + 0.1 * 3.14159265358979, 1e-12);
  // The arc does not reach the centre of the corner's cell, so the arc's middle represents the cell.
  EXPECT_NEAR(nearest(stripes, bend), 0.2 * (std::sqrt(2.0) - 1.0), 1e-12);
  EXPECT_NEAR(nearest(stripes, stripes.point_of({1, 1})), 0.0, 1e-12);
}

TEST(Stripes, APointStandsForEveryLineCell) {
  const Map map = with_corner("300 mm",
                              "________\n"
                              "_111111_\n"
                              "_1____1_\n"
                              "_1____1_\n"
                              "_1____1_\n"
                              "_111111_\n"
                              "_1______\n");
  const Stripes stripes(map, kReach);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const CellAt cell = map.cell_at(i);
    if (!is_line(map.at(cell))) continue;
    EXPECT_NEAR(nearest(stripes, stripes.point_of(cell)), 0.0, 1e-12) << cell.x << ',' << cell.y;
    EXPECT_LT(length(stripes.point_of(cell) - map.centre(cell)), 0.125) << cell.x << ',' << cell.y;
  }
  EXPECT_EQ(stripes.point_of({1, 5}), map.centre({1, 5}));  // a fork is not rounded
}

TEST(Stripes, JunctionsStaySquare) {
  const Map map = with_corner("100 mm", "_1_\n_1_\n111\n");
  const Stripes stripes(map, kReach);
  for (const Stripe& stripe : stripes.all()) EXPECT_EQ(stripe.radius, 0.0);
}

TEST(Stripes, ALegBetweenTwoBendsIsSharedAndTheBendsAreReported) {
  const Map map = with_corner("100 mm",
                              "111____\n"
                              "__1____\n"
                              "__11111\n");
  const Stripes fits(map, kReach);
  EXPECT_THAT(fits.tight_bends(), IsEmpty());
  const Map tight = with_corner("100 mm",
                                "111____\n"
                                "__11111\n"
                                "_______\n");
  const Stripes stripes(tight, kReach);
  ASSERT_EQ(stripes.tight_bends().size(), 2u);
  EXPECT_EQ(stripes.tight_bends()[0].cell, (CellAt{2, 0}));
  EXPECT_DOUBLE_EQ(stripes.tight_bends()[0].radius_m, 0.05);
  EXPECT_EQ(tight_bends(tight).size(), 2u);
}

TEST(Stripes, ALegThatEndsLeavesAllOfItselfToTheBend) {
  const Map map = with_corner("200 mm", "111\n__1\n__1\n");
  EXPECT_THAT(tight_bends(map), IsEmpty());
  EXPECT_EQ(tight_bends(with_corner("201 mm", "111\n__1\n__1\n")).size(), 1u);
}

TEST(Stripes, AGapIsFollowedButNotSeenAndIsAsLongAsItsCells) {
  const Map map = with_corner("0 mm", "_______\n1113311\n_______\n");
  const Stripes stripes(map, kReach);
  const Vec2 west_edge = (map.centre({2, 1}) + map.centre({3, 1})) * 0.5;
  const Vec2 east_edge = (map.centre({4, 1}) + map.centre({5, 1})) * 0.5;
  EXPECT_NEAR(nearest(stripes, map.centre({3, 1})), 0.0, 1e-12);
  // Paint reaches half a line's width beyond the stripes' ends, exactly to the edges of the gap's cells.
  EXPECT_NEAR(nearest(stripes, west_edge, true), map.line_m / 2, 1e-12);
  EXPECT_NEAR(nearest(stripes, east_edge, true), map.line_m / 2, 1e-12);
  EXPECT_NEAR(total_length(stripes), 0.6, 1e-12);
}

TEST(Stripes, ASingleCellBetweenGapsKeepsSomePaint) {
  const Map map = parse_map("+++\ncell = \"20 mm\"\n[legend]\n3 = \"gap\"\n+++\n1131311\n", "m.map");
  const Stripes stripes(map, kReach);
  EXPECT_NEAR(nearest(stripes, map.centre({3, 0}), true), 0.0, 1e-12);
  EXPECT_GT(nearest(stripes, map.centre({2, 0}), true), 0.01);
}

TEST(Stripes, AGapWithinAnArcLeavesTheRestOfItPainted) {
  const Map map = with_corner("400 mm",
                              "_______\n"
                              "_111111\n"
                              "_1_____\n"
                              "_3_____\n"
                              "_1_____\n"
                              "_1_____\n"
                              "_1_____\n");
  const Stripes stripes(map, kReach);
  EXPECT_NEAR(total_length(stripes), 0.1 + 0.1 + 0.2 * 3.14159265358979, 1e-9);
  const Vec2 gap = stripes.point_of({1, 3});
  EXPECT_NEAR(nearest(stripes, gap), 0.0, 1e-12);
  EXPECT_GT(nearest(stripes, gap, true), 0.03);
  for (const CellAt cell : {CellAt{1, 1}, CellAt{3, 1}, CellAt{1, 5}})
    EXPECT_NEAR(nearest(stripes, stripes.point_of(cell), true), 0.0, 1e-12);
}

// Tests random lines with random corners. A query by cell must find every stripe that is within reach. The
// centre line must be unbroken.
TEST(Stripes, AQueryByCellFindsEveryStripeWithinReach) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const NoiseStream noise(seed, 0, "map", "test");
    Map map;
    map.width = 40;
    map.height = 21;
    map.cell_m = 0.05;
    map.corner_m = seed % 3 * 0.06;
    for (std::uint64_t i = 0; i < 40 * 21; ++i) {
      const double u = noise.uniform(i);
      map.cells.push_back(u < 0.35 ? Cell::line : u < 0.4 ? Cell::gap : Cell::floor);
    }
    const double reach = 0.03 + static_cast<double>(seed) * 0.002;
    const Stripes stripes(map, reach);
    for (std::uint64_t n = 0; n < 100; ++n) {
      const Vec2 p{noise.uniform(10'000 + 2 * n) * 2.0, noise.uniform(10'001 + 2 * n) * 1.05};
      const CellAt cell{static_cast<int>(p.x / map.cell_m),
                        map.height - 1 - static_cast<int>(p.y / map.cell_m)};
      const auto near = stripes.near(cell);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (std::uint32_t i = 0; i < stripes.all().size(); ++i) {
        if (distance(stripes.all()[i], p) > reach) continue;
        ASSERT_TRUE(std::binary_search(near.begin(), near.end(), i))
            << "seed " << seed << " at " << p.x << ',' << p.y;
      }
    }
    for (std::size_t i = 0; i < map.cells.size(); ++i)
      if (is_line(map.cells[i])) {
        ASSERT_NEAR(nearest(stripes, stripes.point_of(map.cell_at(i))), 0.0, 1e-9);
      }
  }
}

TEST(Stripes, NothingIsNearACellOutsideTheMap) {
  const Map map = parse_map("111\n", "m.map");
  const Stripes stripes(map, kReach);
  EXPECT_THAT(stripes.near({-1, 0}), IsEmpty());
  EXPECT_THAT(stripes.near({3, 0}), IsEmpty());
  EXPECT_THAT(stripes.near({0, 1}), IsEmpty());
  EXPECT_THAT(stripes.near({0, 0}), ElementsAre(0u));
}

}  // namespace robosim::map::stripes_test
