// Tests many bodies on one floor. The world finds their contacts without examining every pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/world/near_bodies.h"
#include "sim/world/radio_channel.h"
#include "sim/world/world.h"
#include "tests/unit/world/maps.h"

namespace robosim::world::many_bodies_test {

std::vector<std::unique_ptr<Body>> crowd(std::size_t count, double width_m, double height_m,
                                         std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto up_to = [&](double most) { return static_cast<double>(random() % 10'001) * 1e-4 * most; };
  std::vector<std::unique_ptr<Body>> bodies;
  for (std::size_t i = 0; i < count; ++i)
    bodies.push_back(
        std::make_unique<Body>(default_body_params(), Pose{{up_to(width_m), up_to(height_m)}, {1.0, 0.0}}));
  return bodies;
}

bool holds(const std::vector<NearBodies::Pair>& pairs, std::uint32_t i, std::uint32_t j) {
  return std::count(pairs.begin(), pairs.end(), NearBodies::Pair{i, j}) +
             std::count(pairs.begin(), pairs.end(), NearBodies::Pair{j, i}) ==
         1;
}

TEST(NearBodies, HoldEveryPairThatMeets) {
  for (const std::size_t count : {2u, 8u, 9u, 60u, 256u}) {
    const auto bodies = crowd(count, 3.0, 2.0, count);
    NearBodies near(3.0, 2.0);
    const std::vector<NearBodies::Pair> found = near.pairs(bodies);
    std::size_t meet = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j) {
        const Vec2 d = bodies[i]->circle_centre() - bodies[j]->circle_centre();
        if (length(d) > bodies[i]->bound_radius() + bodies[j]->bound_radius()) continue;
        ++meet;
        EXPECT_TRUE(holds(found, i, j)) << i << " and " << j;
      }
    EXPECT_TRUE(count <= 9 || meet > 0);
    EXPECT_EQ(near.pairs(bodies), found) << "a repeated query finds the same pairs";
  }
}

TEST(NearBodies, AreFewOnALargeFloorAndGoBeyondItsEdge) {
  auto bodies = crowd(256, 100.0, 100.0, 1);
  bodies.push_back(std::make_unique<Body>(default_body_params(), Pose{{-5.0, -5.0}, {1.0, 0.0}}));
  bodies.push_back(std::make_unique<Body>(default_body_params(), Pose{{-5.0, -5.05}, {1.0, 0.0}}));
  NearBodies near(100.0, 100.0);
  const auto& found = near.pairs(bodies);
  EXPECT_LT(found.size(), 100u);
  EXPECT_TRUE(holds(found, 256, 257));
}

TEST(World, WhereManyTouchAtOnceTheOrderOfTheirNumbersDoesNotShow) {
  const map::Map map = empty_map(60, 60);
  for (const std::size_t count : {4u, 20u}) {
    const auto places = crowd(count, 0.05 * static_cast<double>(count), 0.5, count);
    const auto ends = [&](bool backwards) {
      World world(map);
      std::vector<Vec2> all(count);
      for (std::size_t i = 0; i < count; ++i)
        world.add_body(default_body_params(), places[backwards ? count - 1 - i : i]->pose());
      for (int tick = 0; tick < 20; ++tick) world.step();
      for (std::size_t i = 0; i < count; ++i)
        all[backwards ? count - 1 - i : i] = world.body(i).pose().position;
      return all;
    };
    const std::vector<Vec2> forwards = ends(false), backwards = ends(true);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(forwards[i].x, backwards[i].x) << i << " of " << count;
      EXPECT_EQ(forwards[i].y, backwards[i].y) << i << " of " << count;
    }
    EXPECT_NE(forwards[0].x, places[0]->pose().position.x) << "the bodies push each other away";
  }
}

TEST(World, SeesOtherBodiesFromAboveTheFloorButThoseInAHand) {
  const map::Map map = empty_map(30, 3);
  World world(map);
  const std::size_t eye = world.add_body(default_body_params(), {{0.2, 0.15}, {1.0, 0.0}});
  const std::size_t other = world.add_body(default_body_params(), {{0.8, 0.15}, {1.0, 0.0}});
  const Vec2 from = {0.3, 0.15};
  const double free = world.range_along(eye, from, {1.0, 0.0}, 5.0);
  EXPECT_LT(free, 0.5);
  world.body(other).lift(true);
  EXPECT_GT(world.range_along(eye, from, {1.0, 0.0}, 5.0), 0.6);
}

TEST(RadioChannel, CarriesBytesToAllOthersOfTheChannelByTheirTimes) {
  RadioChannel air;
  const std::size_t a = air.add_radio(1), b = air.add_radio(1), c = air.add_radio(2), d = air.add_radio(1);
  air.send(a, 'x', 20);
  air.send(d, 'y', 10);
  EXPECT_FALSE(air.take(a, 10)) << "the byte is not received before its time";
  EXPECT_EQ(air.take(a, 100)->byte, 'y');
  EXPECT_FALSE(air.take(a, 100)) << "a radio does not receive its own byte";
  EXPECT_EQ(air.take(b, 100)->byte, 'y');
  EXPECT_EQ(air.take(b, 100)->at, 20);
  EXPECT_FALSE(air.take(c, 100)) << "c is on another channel";
  const RadioChannel::State before = air.save();
  EXPECT_TRUE(air.take(d, 100));
  air.restore(before);
  EXPECT_TRUE(air.take(d, 100));
}

TEST(RadioChannel, BringsWhatComesAtOnceInAnOrderThatNumbersDoNotShowIn) {
  for (const bool a_first : {false, true}) {
    RadioChannel air;
    const std::size_t a = air.add_radio(1), b = air.add_radio(1), c = air.add_radio(1);
    air.send(a_first ? a : b, a_first ? 'p' : 'q', 20);
    air.send(a_first ? b : a, a_first ? 'q' : 'p', 20);
    EXPECT_EQ(air.take(c, 100)->byte, 'p');
    EXPECT_EQ(air.take(c, 100)->byte, 'q');
  }
}

}  // namespace robosim::world::many_bodies_test
