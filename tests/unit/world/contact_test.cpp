// Tests contacts of bodies with walls, obstacles and other bodies.
#include <gtest/gtest.h>

#include <cmath>

#include "maps.h"
#include "sim/world/world.h"
#include "tests/support/effort.h"

namespace robosim::world::contact_test {

void drive(Body& body, double left_drive, double right_drive) {
  body.command(left, {left_drive, 0.0});
  body.command(right, {right_drive, 0.0});
}

void run(World& world, double seconds) {
  for (int i = 0; i < static_cast<int>(seconds * 1000.0 + 0.5); ++i) world.step();
}

Vec2 direction(double degrees) {
  const double a = degrees * 3.14159265358979323846 / 180.0;
  return {std::cos(a), std::sin(a)};
}

// Returns the default parameters with stronger motors: the rate is `rate_factor` times as high, and the
// torque is three times as high.
BodyParams fast(double rate_factor) {
  BodyParams p = default_body_params();
  for (WheelParams& w : p.wheel) {
    w.no_load_rate *= rate_factor;
    w.stall_torque *= 3.0;
  }
  return p;
}

enum class Shape { circle, small_circle, box, triangle };

std::string name_of(Shape shape) {
  static constexpr const char* kNames[] = {"circle", "small_circle", "box", "triangle"};
  return kNames[static_cast<int>(shape)];
}

BodyParams shaped(BodyParams p, Shape shape) {
  if (shape == Shape::small_circle) p.radius_m = 0.004;
  if (shape == Shape::box) p.outline = {{-0.06, -0.07}, {0.11, -0.07}, {0.11, 0.07}, {-0.06, 0.07}};
  if (shape == Shape::triangle) p.outline = {{-0.05, -0.05}, {0.1, 0.0}, {-0.05, 0.05}};
  return p;
}

// Returns the depth of the body's outline inside walls or obstacles, at the deepest of many points.
double inside_walls(const map::Map& map, const Body& body) {
  const BodyParams& p = body.params();
  double deepest = 0.0;
  const auto sample = [&](Vec2 at_body) {
    const Vec2 w = body.pose().to_world(at_body);
    const int column = static_cast<int>(std::floor(w.x / map.cell_m));
    const int row = map.height - 1 - static_cast<int>(std::floor(w.y / map.cell_m));
    const map::Cell cell = map.at({column, row});
    if (cell != map::Cell::wall && cell != map::Cell::obstacle) return;
    const double x = w.x / map.cell_m - column, y = w.y / map.cell_m - std::floor(w.y / map.cell_m);
    deepest = std::max(deepest, std::min({x, 1.0 - x, y, 1.0 - y}) * map.cell_m);
  };
  if (p.outline.empty()) {
    for (int i = 0; i < 360; ++i) sample(p.centre + direction(i) * p.radius_m);
  }
  for (std::size_t i = 0; i < p.outline.size(); ++i) {
    const Vec2 a = p.outline[i], b = p.outline[(i + 1) % p.outline.size()];
    for (int k = 0; k < 20; ++k) sample(a + (b - a) * (k / 20.0));
  }
  return deepest;
}

class OfEveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Contact, OfEveryShape,
                         testing::Values(Shape::circle, Shape::small_circle, Shape::box, Shape::triangle),
                         [](const auto& shape) { return name_of(shape.param); });

TEST_P(OfEveryShape, NeverPassesAOneCellWallAtAnySpeedFromAnyAngle) {
  std::vector<std::string> rows(30, std::string(30, ' '));
  for (int i = 10; i < 20; ++i) rows[10][i] = rows[19][i] = rows[i][10] = rows[i][19] = '#';
  const map::Map map = map_of(rows);
  for (const double speed_factor : {1.0, 8.0, 100.0}) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
      World world(map);
      Body& body = world.body(
          world.add_body(shaped(fast(speed_factor), GetParam()), {{1.5, 1.5}, direction(degrees)}));
      drive(body, 1.0, 1.0);
      for (int i = 0; i < 1500; ++i) {
        world.step();
        ASSERT_TRUE(std::fabs(body.pose().position.x - 1.5) < 0.4 &&
                    std::fabs(body.pose().position.y - 1.5) < 0.4)
            << degrees << " degrees, tick " << i;
        if (i % 20 == 0) {
          ASSERT_LT(inside_walls(map, body), 0.002) << degrees << " degrees, tick " << i;
        }
      }
      ASSERT_GE(body.collisions(), 1) << degrees;
    }
  }
}

// The motors immediately reach 100 m/s, the maximum speed of a body. This is ten cells per tick.
TEST_P(OfEveryShape, NeverPassesAThinWallAtTheHighestSpeed) {
  std::vector<std::string> rows(300, std::string(300, ' '));
  for (int i = 50; i < 250; ++i) rows[50][i] = rows[249][i] = rows[i][50] = rows[i][249] = '#';
  map::Map map = map_of(rows);
  map.cell_m = 0.01;
  BodyParams p = shaped(fast(200.0), GetParam());
  p.grip = 1e6;
  for (WheelParams& w : p.wheel) w.stall_torque *= 1e4;
  for (int degrees = 0; degrees < 360; degrees += 360 / test::rounds(36)) {
    World world(map);
    Body& body = world.body(world.add_body(p, {{1.5, 1.5}, direction(degrees)}));
    drive(body, 1.0, 1.0);
    double top = 0.0;
    for (int i = 0; i < 100; ++i) {
      world.step();
      top = std::max(top, body.speed());
      ASSERT_TRUE(std::fabs(body.pose().position.x - 1.5) < 1.0 &&
                  std::fabs(body.pose().position.y - 1.5) < 1.0)
          << degrees << " degrees, tick " << i;
    }
    ASSERT_GT(top, 90.0);
    ASSERT_LT(inside_walls(map, body), 0.002) << degrees;
  }
}

TEST_P(OfEveryShape, TheMapsEdgeIsAWall) {
  const map::Map map = empty_map(5, 4);
  for (int degrees = 0; degrees < 360; degrees += 30) {
    World world(map);
    Body& body = world.body(world.add_body(shaped(fast(4.0), GetParam()), {{0.25, 0.2}, direction(degrees)}));
    drive(body, 1.0, 0.95);
    run(world, 3.0);
    ASSERT_GE(body.collisions(), 1);
    ASSERT_LT(inside_walls(map, body), 0.002);
  }
}

TEST_P(OfEveryShape, ALastingContactCountsOnce) {
  const map::Map map = empty_map(20, 10);
  World world(map);
  Body& body =
      world.body(world.add_body(shaped(default_body_params(), GetParam()), {{1.5, 0.5}, {1.0, 0.0}}));
  drive(body, 1.0, 1.0);
  run(world, 4.0);
  EXPECT_EQ(body.collisions(), 1);
  EXPECT_TRUE(body.in_contact());
  EXPECT_NEAR(body.speed(), 0.0, 1e-3);
  drive(body, -1.0, -1.0);
  run(world, 1.0);
  EXPECT_FALSE(body.in_contact());
  drive(body, 1.0, 1.0);
  run(world, 3.0);
  EXPECT_EQ(body.collisions(), 2);
}

TEST(Contact, AgainstAWallTheWheelsStandWhereTheGripIsGood) {
  const map::Map map = empty_map(20, 10);
  World world(map);
  BodyParams p = default_body_params();
  p.grip = 5.0;
  Body& body = world.body(world.add_body(p, {{1.8, 0.5}, {1.0, 0.0}}));
  drive(body, 1.0, 1.0);
  run(world, 2.0);
  const double angle = body.wheel_angle(left);
  run(world, 1.0);
  EXPECT_NEAR(body.wheel_angle(left), angle, 1e-9);
  p.grip = 0.2;
  Body& slippery = world.body(world.add_body(p, {{1.8, 0.2}, {1.0, 0.0}}));
  drive(slippery, 1.0, 1.0);
  run(world, 2.0);
  EXPECT_GT(slippery.wheel_rate(left), 5.0);
  EXPECT_NEAR(slippery.speed(), 0.0, 1e-6);
}

TEST(Contact, AnObstacleCellStopsABody) {
  const map::Map map = map_of({"          ", "...x......", "          "});
  World world(map);
  Body& body = world.body(world.add_body(default_body_params(), {{0.12, 0.15}, {1.0, 0.0}}));
  drive(body, 1.0, 1.0);
  run(world, 2.0);
  EXPECT_NEAR(body.pose().position.x, 0.3 - 0.08, 1e-3);
  EXPECT_EQ(body.collisions(), 1);
}

TEST_P(OfEveryShape, AnObstacleCanBePutDownAndTakenAway) {
  const map::Map map = empty_map(40, 10);
  World world(map);
  const BodyParams p = shaped(default_body_params(), GetParam());
  Body& body = world.body(world.add_body(p, {{0.5, 0.5}, {1.0, 0.0}}));
  const int obstacle = world.add_obstacle({1.2, 0.5}, 0.05);
  drive(body, 1.0, 1.0);
  run(world, 3.0);
  double front = p.radius_m;
  for (const Vec2 corner : p.outline) front = std::max(p.outline[0].x, corner.x);
  if (GetParam() == Shape::box) front = 0.11;
  if (GetParam() == Shape::triangle) front = 0.1;
  EXPECT_NEAR(body.pose().position.x, 1.15 - front, 1e-3);
  EXPECT_EQ(body.collisions(), 1);
  world.remove_obstacle(obstacle);
  run(world, 2.0);
  EXPECT_GT(body.pose().position.x, 1.3);
}

TEST(Contact, AlongASmoothWallItSlides) {
  const map::Map map = empty_map(100, 10);
  World world(map);
  BodyParams p = default_body_params();
  p.wall_friction = 0.02;
  Body& body = world.body(world.add_body(p, {{0.5, 0.1}, direction(-10)}));
  drive(body, 1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    world.step();
    ASSERT_GE(body.pose().position.y, 0.08 - 1e-9);
  }
  EXPECT_GT(body.pose().position.x, 1.0);
  EXPECT_EQ(body.collisions(), 1);
}

TEST(Contact, ARoughWallTurnsItTowardsItself) {
  const map::Map map = empty_map(100, 10);
  World world(map);
  BodyParams p = default_body_params();
  p.wall_friction = 0.6;
  Body& body = world.body(world.add_body(p, {{0.5, 0.1}, direction(-20)}));
  drive(body, 1.0, 1.0);
  run(world, 1.0);
  EXPECT_LT(body.pose().heading.y, direction(-25).y);
}

TEST(Contact, NeverGainsEnergyFromWalls) {
  const map::Map map = map_of({"#######", "#     #", "#  #  #", "#     #", "#######"});
  for (const Shape shape : {Shape::circle, Shape::box, Shape::triangle}) {
    BodyParams p = shaped(fast(3.0), shape);
    p.radius_m = 0.06;
    for (Vec2& corner : p.outline) corner = corner * 0.5;
    World world(map);
    Body& body = world.body(world.add_body(p, {{0.2, 0.2}, direction(20)}));
    unsigned random = 3;
    for (int i = 0; i < 20000; ++i) {
      if (i % 100 == 0) {
        random = random * 1664525u + 1013904223u;
        drive(body, static_cast<int>(random >> 8 & 511) / 255.5 - 0.8,
              static_cast<int>(random >> 17 & 511) / 255.5 - 0.8);
      }
      const double kinetic = body.kinetic_energy(), drawn = body.energy();
      world.step();
      ASSERT_LE(body.kinetic_energy() - kinetic, body.energy() - drawn + 1e-9) << "tick " << i;
      ASSERT_LT(inside_walls(map, body), 0.003) << "tick " << i;
    }
  }
}

TEST(Contact, TwoRobotsThatMeetStopEachOther) {
  const map::Map map = empty_map(40, 10);
  World world(map);
  Body& a = world.body(world.add_body(default_body_params(), {{0.5, 0.5}, {1.0, 0.0}}));
  Body& b = world.body(world.add_body(default_body_params(), {{2.5, 0.5}, {-1.0, 0.0}}));
  drive(a, 1.0, 1.0);
  drive(b, 1.0, 1.0);
  run(world, 5.0);
  EXPECT_NEAR(length(a.pose().position - b.pose().position), 0.16, 2e-3);
  EXPECT_NEAR(a.pose().position.x, 1.42, 0.02);
  EXPECT_EQ(a.collisions(), 1);
  EXPECT_EQ(b.collisions(), 1);
  EXPECT_TRUE(a.in_contact() && b.in_contact());
}

TEST(Contact, PutIntoAWallItStaysUntilItIsLiftedOut) {
  const map::Map map = map_of({"#####", "#####", "#####", "##   ", "#####"});
  World world(map);
  Body& body = world.body(world.add_body(default_body_params(), {{0.25, 0.35}, {1.0, 0.0}}));
  drive(body, 1.0, 1.0);
  run(world, 1.0);
  EXPECT_TRUE(body.in_contact());
  EXPECT_NEAR(body.distance(), 0.0, 0.01);
  body.place({{0.35, 0.15}, {1.0, 0.0}});
  EXPECT_FALSE(body.in_contact());
}

// Tests the lower bound of the distance to walls. Because of this bound, most ticks need no search for
// contacts.
TEST(Walls, ClearanceNeverPromisesTooMuch) {
  unsigned random = 5;
  for (int round = 0; round < 30; ++round) {
    std::vector<std::string> rows(12, std::string(15, ' '));
    for (std::string& row : rows) {
      for (char& c : row) {
        random = random * 1664525u + 1013904223u;
        if ((random >> 16) % 20 == 0) c = random >> 24 & 1 ? '#' : 'x';
      }
    }
    const map::Map map = map_of(rows);
    const Walls walls(map);
    for (int i = 0; i < 500; ++i) {
      random = random * 1664525u + 1013904223u;
      const Vec2 p{(random >> 8 & 1023) / 1023.0 * 1.6 - 0.05, (random >> 20 & 1023) / 1023.0 * 1.3 - 0.05};
      double nearest = std::min({p.x, p.y, 1.5 - p.x, 1.2 - p.y});
      for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 15; ++x) {
          if (rows[y][x] == ' ') continue;
          const Vec2 c = map.centre({x, y});
          const double dx = std::max(std::fabs(p.x - c.x) - 0.05, 0.0),
                       dy = std::max(std::fabs(p.y - c.y) - 0.05, 0.0);
          nearest = std::min(nearest, std::hypot(dx, dy));
        }
      }
      const double bound = walls.clearance(p);
      ASSERT_LE(bound, std::max(nearest, 0.0) + 1e-12);
      if (nearest > 0.0) {
        ASSERT_GE(bound, std::max(nearest / std::sqrt(2.0) - 0.1, 0.0) - 1e-12);
      }
    }
  }
}

}  // namespace robosim::world::contact_test
