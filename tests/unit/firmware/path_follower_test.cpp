#include "PathFollower.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using Side = PathFollower::Side;
using State = PathFollower::State;

// What the three sensors see, for followers of either side: `near` is the preferred side's.
struct Seen {
  bool near, middle, far;
};
constexpr Seen kLine{false, true, false};
constexpr Seen kOffTheEdge{false, false, false};  // just beside the edge, or no line at all
constexpr Seen kFarOnly{false, false, true};      // beside the line, which the far sensor sees
constexpr Seen kBranch{true, true, false};
constexpr Seen kTee{true, true, true};

class PathFollowerTest : public ::testing::TestWithParam<Side> {
 protected:
  // The sensors see this for so long, looked at every 2 ms.
  void see(Seen seen, int ms) {
    for (int i = 0; i < ms; i += 2) {
      now += 2;
      const bool left = GetParam() == Side::left;
      path.update(left ? seen.near : seen.far, seen.middle, left ? seen.far : seen.near, now);
    }
  }
  // The turn it makes, in steps of PWM between the wheels: positive to the preferred side.
  int turn() const {
    const int to_the_left = path.rightSpeed() - path.leftSpeed();
    return GetParam() == Side::left ? to_the_left : -to_the_left;
  }
  int speed() const { return (path.leftSpeed() + path.rightSpeed()) / 2; }
  // Sees this until the state changes; how long that took, in ms.
  int see_until_change(Seen seen, int most_ms = 2000) {
    const State before = path.state();
    int ms = 0;
    for (; path.state() == before && ms < most_ms; ms += 2) see(seen, 2);
    return ms;
  }

  PathFollower path{GetParam()};
  std::uint32_t now = 0xFFFFFF00u;  // so that the clock wraps round during the test
};

INSTANTIATE_TEST_SUITE_P(OnEitherSide, PathFollowerTest, ::testing::Values(Side::left, Side::right),
                         [](const auto& side) { return side.param == Side::left ? "left" : "right"; });

TEST_P(PathFollowerTest, RunsAlongTheEdgeOfItsSide) {
  see(kLine, 50);
  EXPECT_GT(turn(), 0) << "on the line it steers to its own side, off the line";
  EXPECT_GT(speed(), 0);
  see(kFarOnly, 50);
  EXPECT_LT(turn(), 0) << "beside the line it steers back";
  EXPECT_GT(speed(), 0);
  EXPECT_EQ(path.state(), State::following);
}

TEST_P(PathFollowerTest, TakesABranchOnItsSide) {
  see(kLine, 300);
  see(kBranch, 70);
  EXPECT_EQ(path.state(), State::crossing);
  EXPECT_EQ(turn(), 0) << "straight on over the branch";
  see(kLine, 4);
  EXPECT_EQ(path.state(), State::rolling);
  see_until_change(kLine);
  EXPECT_EQ(path.state(), State::stopping);
  see_until_change(kLine);
  EXPECT_EQ(path.state(), State::turning);
  see(kLine, 60);
  EXPECT_EQ(path.state(), State::turning) << "it still stands over the line it came on";
  EXPECT_GT(turn(), 0);
  EXPECT_EQ(speed(), 0);
  see(kOffTheEdge, 300);
  EXPECT_EQ(path.state(), State::turning);
  see(kLine, 2);
  EXPECT_EQ(path.state(), State::settling);
  see_until_change(kLine);
  EXPECT_EQ(path.state(), State::following);
  EXPECT_EQ(path.branches(), 1);
  EXPECT_EQ(path.ends(), 0);
}

TEST_P(PathFollowerTest, DoesNotTurnIntoTheLineItCameOnWhereItStoodAslant) {
  see(kLine, 300);
  see(kBranch, 70);
  while (path.state() != State::turning) see(kOffTheEdge, 2);
  see(kOffTheEdge, 220);
  see(kLine, 40);
  EXPECT_EQ(path.state(), State::turning);
  see(kOffTheEdge, 150);
  see(kLine, 2);
  EXPECT_EQ(path.state(), State::settling);
}

TEST_P(PathFollowerTest, TakesItsOwnSideOfATee) {
  see(kLine, 300);
  see(kTee, 70);
  see_until_change(kOffTheEdge);
  see_until_change(kOffTheEdge);
  see_until_change(kOffTheEdge);
  EXPECT_EQ(path.state(), State::turning);
  see(kOffTheEdge, 2);
  EXPECT_GT(turn(), 0);
}

TEST_P(PathFollowerTest, PassesABranchOnTheOtherSide) {
  see(kLine, 300);
  see({false, true, true}, 80);
  see(kLine, 300);
  EXPECT_EQ(path.state(), State::following);
  EXPECT_EQ(path.branches(), 0);
}

TEST_P(PathFollowerTest, TurnsToTheOtherSideWhereTheLineEnds) {
  see(kLine, 300);
  see_until_change(kOffTheEdge);
  EXPECT_EQ(path.state(), State::rolling);
  see_until_change(kOffTheEdge);
  EXPECT_EQ(path.state(), State::stopping);
  see_until_change(kOffTheEdge);
  EXPECT_EQ(path.state(), State::turning);
  see(kOffTheEdge, 2);
  EXPECT_LT(turn(), 0);
  see(kOffTheEdge, 600);
  EXPECT_EQ(path.state(), State::turning) << "until there is a line, however far round";
  see(kLine, 2);
  EXPECT_EQ(path.state(), State::settling);
  EXPECT_EQ(path.ends(), 1);
  EXPECT_EQ(path.branches(), 0);
}

TEST_P(PathFollowerTest, DoesNotTakeTheFloorBesideTheEdgeForTheEndOfTheLine) {
  see(kLine, 300);
  see(kOffTheEdge, 76);  // the wide part of the zigzag: a line's width, and a little
  EXPECT_EQ(path.state(), State::following);
}

TEST_P(PathFollowerTest, GoesOnWhenTheLineComesBackWhileItRollsOnPastAnEnd) {
  see(kLine, 300);
  see_until_change(kOffTheEdge);
  ASSERT_EQ(path.state(), State::rolling);
  see(kLine, 2);
  EXPECT_EQ(path.state(), State::following);
  EXPECT_EQ(path.ends(), 0);
}

TEST_P(PathFollowerTest, DoesNotBelieveAFlicker) {
  see(kLine, 300);
  see(kBranch, 4);
  see(kLine, 100);
  see(kOffTheEdge, 20);
  see(kLine, 100);
  EXPECT_EQ(path.state(), State::following);
}

TEST_P(PathFollowerTest, DoesNotTakeTheLineItselfForABranch) {
  see(kLine, 300);
  see({true, false, false}, 400);  // it has slipped away under the sensor
  EXPECT_EQ(path.branches(), 0);
  EXPECT_TRUE(path.state() == State::following || path.state() == State::crossing);
}

TEST_P(PathFollowerTest, DoesNotTakeTheBranchItHasJustTurnedIntoForAnother) {
  see(kLine, 300);
  see(kBranch, 70);
  while (path.state() != State::turning) see(kLine, 2);
  see(kOffTheEdge, 300);
  while (path.state() != State::following) see(kLine, 2);
  see(kBranch, 100);  // not straight on the line yet
  EXPECT_EQ(path.state(), State::following);
  see(kLine, 20);
  see(kBranch, 20);
  EXPECT_EQ(path.state(), State::crossing);
}

TEST_P(PathFollowerTest, MeasuresItsSpeedByTheWidthOfABranch) {
  int rolled[2];
  for (const int slow : {0, 1}) {
    path = PathFollower(GetParam());
    see(kLine, 300);
    see(kBranch, slow ? 120 : 60);
    see(kLine, 2);
    EXPECT_NEAR(path.widthMs(), slow ? 120 : 60, 4);
    rolled[slow] = see_until_change(kLine);
  }
  EXPECT_NEAR(rolled[1], 2 * rolled[0], 6);
}

TEST_P(PathFollowerTest, KeepsItsMeasureWhereABranchCannotHaveBeenOneWidth) {
  see(kLine, 300);
  see(kBranch, 20);
  see(kLine, 2);
  EXPECT_EQ(path.widthMs(), PathFollower::Settings().width_ms);
}

TEST(PathFollower, OfOneSideIsTheMirrorImageOfTheOther) {
  std::mt19937 random(1);
  PathFollower left(Side::left);
  PathFollower right(Side::right);
  Seen seen = kLine;
  for (std::uint32_t now = 0; now < 60000; now += 2) {
    if (random() % 20 == 0) seen = {random() % 4 == 0, random() % 2 == 0, random() % 3 == 0};
    left.update(seen.near, seen.middle, seen.far, now);
    right.update(seen.far, seen.middle, seen.near, now);
    ASSERT_EQ(left.leftSpeed(), right.rightSpeed()) << now;
    ASSERT_EQ(left.rightSpeed(), right.leftSpeed()) << now;
    ASSERT_EQ(left.state(), right.state()) << now;
  }
  EXPECT_GT(left.branches(), 10);
  EXPECT_GT(left.ends(), 10);
}

}  // namespace
