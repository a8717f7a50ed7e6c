#include "PathFollower.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace path_follower_test {

using Side = PathFollower::Side;
using State = PathFollower::State;

// Readings of the three sensors. `near` is the sensor on the follower's preferred side, left or right.
struct Seen {
  bool near, middle, far;
};
constexpr Seen kLine{false, true, false};
constexpr Seen kOffTheEdge{false, false, false};  // just outside the line's edge, or without a line
constexpr Seen kFarOnly{false, false, true};      // next to the line, which only the far sensor sees
constexpr Seen kBranch{true, true, false};
constexpr Seen kTee{true, true, true};

class PathFollowerTest : public ::testing::TestWithParam<Side> {
 protected:
  // Updates the follower with the readings `seen` every 2 ms, for `ms` milliseconds.
  void see(Seen seen, int ms) {
    for (int i = 0; i < ms; i += 2) {
      now += 2;
      const bool left = GetParam() == Side::left;
      path.update(left ? seen.near : seen.far, seen.middle, left ? seen.far : seen.near, now);
    }
  }
  // Returns the difference between the wheels' PWM values. A positive result is a turn to the preferred side.
  int turn() const {
    const int to_the_left = path.rightSpeed() - path.leftSpeed();
    return GetParam() == Side::left ? to_the_left : -to_the_left;
  }
  int speed() const { return (path.leftSpeed() + path.rightSpeed()) / 2; }
  // Updates the follower with the readings `seen` until its state changes. Returns the time that this takes,
  // in ms.
  int see_until_change(Seen seen, int most_ms = 2000) {
    const State before = path.state();
    int ms = 0;
    for (; path.state() == before && ms < most_ms; ms += 2) see(seen, 2);
    return ms;
  }

  PathFollower path{GetParam()};
  std::uint32_t now = 0xFFFFFF00u;  // the clock wraps during the test
};

INSTANTIATE_TEST_SUITE_P(OnEitherSide, PathFollowerTest, ::testing::Values(Side::left, Side::right),
                         [](const auto& side) { return side.param == Side::left ? "left" : "right"; });

TEST_P(PathFollowerTest, RunsAlongTheEdgeOfItsSide) {
  see(kLine, 50);
  EXPECT_GT(turn(), 0) << "on the line, the robot steers to the preferred side";
  EXPECT_GT(speed(), 0);
  see(kFarOnly, 50);
  EXPECT_LT(turn(), 0) << "next to the line, the robot steers back";
  EXPECT_GT(speed(), 0);
  EXPECT_EQ(path.state(), State::following);
}

TEST_P(PathFollowerTest, TakesABranchOnItsSide) {
  see(kLine, 300);
  see(kBranch, 70);
  EXPECT_EQ(path.state(), State::crossing);
  EXPECT_EQ(turn(), 0) << "the robot goes straight on over the branch";
  see(kLine, 4);
  EXPECT_EQ(path.state(), State::rolling);
  see_until_change(kLine);
  EXPECT_EQ(path.state(), State::stopping);
  see_until_change(kLine);
  EXPECT_EQ(path.state(), State::turning);
  see(kLine, 60);
  EXPECT_EQ(path.state(), State::turning) << "the robot is still over the old line";
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
  EXPECT_EQ(path.state(), State::turning) << "the robot turns until a sensor sees a line";
  see(kLine, 2);
  EXPECT_EQ(path.state(), State::settling);
  EXPECT_EQ(path.ends(), 1);
  EXPECT_EQ(path.branches(), 0);
}

TEST_P(PathFollowerTest, DoesNotTakeTheFloorBesideTheEdgeForTheEndOfTheLine) {
  see(kLine, 300);
  see(kOffTheEdge, 76);  // as in a wide zigzag; the line ends only after 84 ms
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
  see({true, false, false}, 400);  // the line has moved under the near sensor
  EXPECT_EQ(path.branches(), 0);
  EXPECT_TRUE(path.state() == State::following || path.state() == State::crossing);
}

TEST_P(PathFollowerTest, DoesNotTakeTheBranchItHasJustTurnedIntoForAnother) {
  see(kLine, 300);
  see(kBranch, 70);
  while (path.state() != State::turning) see(kLine, 2);
  see(kOffTheEdge, 300);
  while (path.state() != State::following) see(kLine, 2);
  see(kBranch, 100);  // the robot is not yet straight on the line
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

// Tests the millisecond at which each output changes, with the default settings.
TEST_P(PathFollowerTest, KeepsToItsTimetable) {
  static const char* const states[] = {"following", "crossing", "rolling", "stopping", "turning", "settling"};
  std::string said = "\n", before;
  int ms = 0;
  const auto look = [&](Seen seen, int most_ms) {
    for (int i = 0; i < most_ms; ++i, ++ms) {
      const bool left = GetParam() == Side::left;
      path.update(left ? seen.near : seen.far, seen.middle, left ? seen.far : seen.near, ++now);
      const std::string does = std::string(states[static_cast<int>(path.state())]) + " at " +
                               std::to_string(speed()) + ", turning by " + std::to_string(turn());
      if (does != before) said += std::to_string(ms) + " ms: " + does + "\n";
      before = does;
    }
  };
  look(kLine, 100);
  look(kBranch, 50);  // a branch, slightly narrower than the initial width
  look(kLine, 430);   // the old line, while the robot turns away
  look(kOffTheEdge, 60);
  look(kLine, 200);  // the branch, at which the turn ends
  look(kOffTheEdge, 40);
  look(kFarOnly, 10);
  look(kOffTheEdge, 300);  // the end of the line
  look(kLine, 100);
  look(kBranch, 154);  // the line itself, after the robot has moved sideways
  look(kOffTheEdge, 63);
  look(kLine, 10);  // not an end: the line reappears while the robot rolls on
  EXPECT_EQ(said, R"(
0 ms: following at 85, turning by 170
107 ms: crossing at 85, turning by 0
150 ms: rolling at 85, turning by 0
201 ms: stopping at -130, turning by 0
251 ms: turning at -130, turning by 0
252 ms: turning at 0, turning by 160
640 ms: settling at 0, turning by -260
665 ms: following at 0, turning by -260
666 ms: following at 85, turning by 170
840 ms: following at 85, turning by -170
950 ms: rolling at 85, turning by 0
970 ms: stopping at -130, turning by 0
1020 ms: turning at -130, turning by 0
1021 ms: turning at 0, turning by -160
1190 ms: settling at 0, turning by 260
1215 ms: following at 0, turning by 260
1216 ms: following at 85, turning by 170
1297 ms: crossing at 85, turning by 0
1443 ms: following at 85, turning by 0
1444 ms: following at 85, turning by -170
1504 ms: rolling at 85, turning by 0
1507 ms: following at 85, turning by 0
1508 ms: following at 85, turning by 170
)");
  EXPECT_EQ(path.branches(), 1);
  EXPECT_EQ(path.ends(), 1);
}

TEST(PathFollower, CountsAStepThatTookLongAsATenthOfASecond) {
  PathFollower path(Side::left);
  path.update(false, true, false, 0);
  path.update(false, false, false, 5000);
  EXPECT_EQ(path.state(), State::rolling) << "100 ms are more than the 84 ms of a line's end";
  PathFollower::Settings settings;
  settings.width_ms = 90;
  PathFollower wider(Side::left, settings);
  wider.update(false, true, false, 0);
  wider.update(false, false, false, 5000);
  EXPECT_EQ(wider.state(), State::following) << "100 ms are less than the 108 ms of a line's end";
}

TEST(PathFollower, TakesSettingsOverTheirWholeRange) {
  PathFollower::Settings settings;
  for (int16_t* speed : {&settings.fast, &settings.slow, &settings.cruise, &settings.turn, &settings.counter})
    *speed = 255;
  settings.stop_ms = settings.settle_ms = settings.noise_ms = settings.end_tenths = settings.past_tenths =
      settings.branch_tenths = 255;
  settings.leave_ms = settings.width_ms = 65535;
  EXPECT_EQ(settings.fast + settings.slow + settings.cruise + settings.turn + settings.counter, 5 * 255);
  EXPECT_EQ(settings.stop_ms + settings.settle_ms + settings.noise_ms + settings.end_tenths +
                settings.past_tenths + settings.branch_tenths,
            6 * 255);
  EXPECT_EQ(settings.leave_ms, 65535);
  EXPECT_EQ(PathFollower(Side::left, settings).widthMs(), 65535);
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

}  // namespace path_follower_test
