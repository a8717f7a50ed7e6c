// Tests LeftPath and RightPath: on a floor without loops they visit every station and return home. LeftPath
// follows the left-hand rule, RightPath the right-hand rule.
#include <robosim/testing.h>

#include "tests/firmware/maps.h"

namespace path_follower_test {

using namespace robosim::testing;

class PathSketch : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ROBOSIM_SKIP_WITHOUT(GetParam()); }
  Trial trial(const std::string& sketch, const std::string& map) const {
    return {.sketch = sketch, .map = map, .robot = "uno3", .target = GetParam(), .goal = "tour"};
  }
};

INSTANTIATE_TEST_SUITE_P(On, PathSketch, Targets("host", "avr", "stm32"), Named());

TEST_P(PathSketch, RightPathTakesTheRightBranchFirst) {
  Simulation robot(trial("RightPath", kTee));
  const Drive tour = robot.run_to_the_end();
  EXPECT_THAT(tour, Reaches("tour"));
  EXPECT_THAT(tour, VisitsInOrder({2, 3, 1}));
  EXPECT_THAT(tour, NeverCollides());
}

TEST_P(PathSketch, LeftPathTakesTheLeftBranchFirst) {
  Simulation robot(trial("LeftPath", kTee));
  const Drive tour = robot.run_to_the_end();
  EXPECT_THAT(tour, Reaches("tour"));
  EXPECT_THAT(tour, VisitsInOrder({3, 2, 1}));
  EXPECT_THAT(tour, NeverCollides());
}

TEST_P(PathSketch, TurnsRoundWhereTheLineEnds) {
  Simulation robot(trial("RightPath", kTee));
  ASSERT_TRUE(robot.run_until(is_at(2), within(20_s)));
  const Drive back = robot.run_until(is_at(3), within(20_s));
  ASSERT_TRUE(back);
  EXPECT_LT(back.distance().mm, 1200.0) << "there is 0.6 m of line between the two stations";
}

class PathSketchOnMapD : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seed, PathSketchOnMapD, Seeds(1, 6), Named());

TEST_P(PathSketchOnMapD, RightPathVisitsTheStationsInTheOrderOfTheirNumbers) {
  Simulation robot({.sketch = "RightPath", .map = "d", .robot = "uno3", .seed = GetParam(), .goal = "tour"});
  EXPECT_THAT(robot.run_to_the_end(), VisitsInOrder({2, 3, 4, 5, 6, 7, 1}));
}

TEST_P(PathSketchOnMapD, LeftPathVisitsThemTheOtherWayRound) {
  Simulation robot({.sketch = "LeftPath", .map = "d", .robot = "uno3", .seed = GetParam(), .goal = "tour"});
  EXPECT_THAT(robot.run_to_the_end(), VisitsInOrder({7, 6, 5, 4, 3, 2, 1}));
}

}  // namespace path_follower_test
