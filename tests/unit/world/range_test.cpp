// Tests the distances that range sensors measure in the world.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/base/trig_series.h"
#include "sim/world/world.h"
#include "tests/unit/world/maps.h"

namespace robosim::world::range_test {

constexpr double kMost = 4.0;
constexpr Vec2 kEast{1.0, 0.0}, kNorth{0.0, 1.0}, kWest{-1.0, 0.0};

// Returns a room of 100 mm cells. It has a wall from column 10 on, and a single wall cell in column 4 of the
// lowest row.
map::Map room() {
  map::Map map = map_of({
      "          ##",
      "          ##",
      "          ##",
      "          ##",
      "    #     ##",
  });
  map.cell_m = 0.1;
  return map;
}

TEST(Range, IsTheWayToAWallOrTheMapsEdge) {
  const map::Map map = room();
  const World world(map);
  EXPECT_DOUBLE_EQ(world.range_along(0, {0.25, 0.25}, kEast, kMost), 0.75);
  EXPECT_DOUBLE_EQ(world.range_along(0, {0.25, 0.25}, kNorth, kMost), 0.25);
  EXPECT_DOUBLE_EQ(world.range_along(0, {0.25, 0.25}, kWest, kMost), 0.25);
  EXPECT_NEAR(world.range_along(0, {0.25, 0.25}, {0.6, 0.8}, kMost), 0.25 / 0.8, 1e-12);
  EXPECT_DOUBLE_EQ(world.range_along(0, {0.25, 0.05}, kEast, kMost), 0.15);
  EXPECT_EQ(world.range_along(0, {0.25, 0.25}, kEast, 0.5), 0.5) << "nothing within the requested range";
  EXPECT_EQ(world.range_along(0, {1.05, 0.25}, kWest, kMost), 0.0) << "from inside a wall";
}

TEST(Range, OfADiscIsToItsNearSide) {
  const map::Map map = room();
  World world(map);
  world.add_obstacle({0.55, 0.25}, 0.05);
  EXPECT_NEAR(world.range_along(0, {0.15, 0.25}, kEast, kMost), 0.35, 1e-12);
  EXPECT_NEAR(world.range_along(0, {0.15, 0.28}, kEast, kMost), 0.4 - 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(world.range_along(0, {0.15, 0.31}, kEast, kMost), 0.85) << "the ray misses the disc";
  EXPECT_EQ(world.range_along(0, {0.55, 0.26}, kEast, kMost), 0.0);
}

TEST(Range, OfAnotherRobotIsToTheCircleAboutIt) {
  const map::Map map = room();
  World world(map);
  BodyParams params = default_body_params();
  params.outline.clear();
  params.radius_m = 0.06;
  params.centre = {0.0, 0.0};
  const std::size_t own = world.add_body(params, {{0.15, 0.25}, kEast});
  const std::size_t other = world.add_body(params, {{0.65, 0.25}, kEast});
  EXPECT_NEAR(world.range_along(own, {0.15, 0.25}, kEast, kMost), 0.44, 1e-12);
  EXPECT_NEAR(world.range_along(other, {0.65, 0.25}, kEast, kMost), 0.35, 1e-12);
  EXPECT_NEAR(world.range_in_beam(own, {0.15, 0.25}, kEast, direction_of(0.1), kMost), 0.44, 1e-12);
}

TEST(Range, OfABeamIsItsNearestPoint) {
  const map::Map map = room();
  World world(map);
  const Vec2 half = direction_of(0.2);
  EXPECT_DOUBLE_EQ(world.range_in_beam(0, {0.45, 0.25}, kEast, half, kMost), 0.55);
  // The first obstacle is inside the beam, but not at its middle. Only the beam's edge reaches the second
  // obstacle.
  world.add_obstacle({0.85, 0.30}, 0.02);
  EXPECT_NEAR(world.range_in_beam(0, {0.45, 0.25}, kEast, half, kMost), std::hypot(0.4, 0.05) - 0.02, 1e-12);
  world.add_obstacle({0.85, 0.15}, 0.025);
  const double edge = world.range_along(0, {0.45, 0.25}, {half.x, -half.y}, kMost);
  EXPECT_LT(edge, 0.55);
  EXPECT_NEAR(world.range_in_beam(0, {0.45, 0.25}, kEast, half, kMost), std::hypot(0.4, 0.05) - 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(world.range_in_beam(0, {0.45, 0.25}, kNorth, half, 0.1), 0.1);
}

// Compares a beam with many rays inside it. No ray finds a shorter distance than the beam, and one ray finds
// nearly the same distance.
TEST(Range, OfABeamIsThatOfTheBestOfManyRays) {
  map::Map map = room();
  World world(map);
  world.add_obstacle({0.62, 0.38}, 0.033);
  world.add_obstacle({0.8, 0.1}, 0.033);
  for (int i = 0; i < 400; ++i) {
    const Vec2 from{0.05 + 0.0021 * i, 0.13 + 0.00067 * i};
    const double angle = 0.37 * i, half = 0.02 + 0.001 * i;
    const double found = world.range_in_beam(0, from, direction_of(angle), direction_of(half), kMost);
    double best = kMost;
    constexpr int kRays = 400;
    for (int k = -kRays; k <= kRays; ++k)
      best = std::min(best, world.range_along(0, from, direction_of(angle + half * k / kRays), kMost));
    EXPECT_LE(found, best + 1e-9) << i;
    EXPECT_GE(found, best - 0.002) << i;
  }
}

TEST(Range, DirectionsAreThoseOfSineAndCosine) {
  for (int i = -700; i <= 700; ++i) {
    const Vec2 d = direction_of(0.01 * i);
    EXPECT_NEAR(d.x, std::cos(0.01 * i), 1e-12);
    EXPECT_NEAR(d.y, std::sin(0.01 * i), 1e-12);
  }
}

}  // namespace robosim::world::range_test
