#include "LineWalker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "line_walk.h"

namespace line_walker_test {

using namespace walked;

// The tests compare exact positions, costs and times, because the navigator builds its map from these values.
TEST(LineWalkerTest, ComesToBothEndsOfALine) {
  Walk walk({{-300, 0, 300, 0}});
  walk.go({kBack, kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 299,4, cost 58; axle at 299.2,0.0, 6.28 rad, 3540 ms
end 1000, heading 2 at -298,0, cost 107; axle at -298.4,0.0, 9.42 rad, 7045 ms
end 0010, heading 0 at 299,5, cost 107; axle at 299.6,0.0, 12.57 rad, 10545 ms
)");
}

TEST(LineWalkerTest, TellsTheWaysOfATee) {
  Walk walk({{-300, 0, 300, 0}, {300, -300, 300, 300}});
  walk.go({kRight, kBack, kOn, kBack, kRight, kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 0111, heading 0 at 300,4, cost 57; axle at 299.1,0.0, 6.28 rad, 3535 ms
end 0001, heading 1 at 294,303, cost 57; axle at 300.0,299.1, 7.85 rad, 5510 ms
junction 0111, heading 3 at 298,4, cost 57; axle at 299.7,0.4, 11.00 rad, 8015 ms
end 0100, heading 3 at 298,-295, cost 57; axle at 300.0,-298.8, 11.00 rad, 9210 ms
junction 0111, heading 1 at 293,4, cost 57; axle at 299.8,-0.6, 14.13 rad, 11715 ms
end 1000, heading 2 at -306,-1, cost 107; axle at -299.3,0.0, 15.71 rad, 14710 ms
junction 0111, heading 0 at 294,4, cost 107; axle at 299.6,0.0, 18.85 rad, 18215 ms
)");
}

TEST(LineWalkerTest, TellsTheWaysOfACross) {
  Walk walk({kTrunk, {300, -300, 300, 300}});
  walk.go({kOn, kBack, kRight, kBack, kLeft});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1111, heading 0 at 300,4, cost 57; axle at 299.1,0.0, 6.28 rad, 3535 ms
end 0010, heading 0 at 598,4, cost 57; axle at 598.2,0.0, 6.28 rad, 4730 ms
junction 1111, heading 2 at 300,0, cost 57; axle at 300.4,0.0, 9.42 rad, 7230 ms
end 0100, heading 3 at 305,-300, cost 57; axle at 300.0,-299.6, 11.00 rad, 9215 ms
junction 1111, heading 1 at 300,0, cost 57; axle at 300.0,-0.6, 14.14 rad, 11715 ms
end 0010, heading 0 at 599,-5, cost 57; axle at 598.8,0.0, 12.57 rad, 13705 ms
)");
}

TEST(LineWalkerTest, TellsAWayToTheLeft) {
  Walk walk({kTrunk, {300, -300, 300, 0}});
  walk.go({kLeft, kBack, kRight});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1011, heading 0 at 300,4, cost 57; axle at 299.0,-0.2, 6.29 rad, 3535 ms
end 0100, heading 3 at 294,-295, cost 57; axle at 300.0,-299.1, 4.71 rad, 5515 ms
junction 1011, heading 1 at 290,4, cost 57; axle at 300.0,-0.9, 7.85 rad, 8020 ms
end 1000, heading 2 at -310,-2, cost 107; axle at -299.4,0.0, 9.42 rad, 11000 ms
)");
}

TEST(LineWalkerTest, TellsAWayToTheRight) {
  Walk walk({kTrunk, {300, 300, 300, 0}});
  walk.go({kRight, kBack, kLeft});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1110, heading 0 at 300,4, cost 57; axle at 298.8,0.2, 6.28 rad, 3530 ms
end 0001, heading 1 at 293,303, cost 57; axle at 300.0,299.3, 7.85 rad, 5505 ms
junction 1110, heading 3 at 298,4, cost 57; axle at 300.0,1.0, 11.00 rad, 8010 ms
end 1000, heading 2 at -301,11, cost 107; axle at -299.1,0.0, 9.42 rad, 10990 ms
)");
}

TEST(LineWalkerTest, TakesBendsToTheRight) {
  Walk walk({{-300, 0, 300, 0}, {300, 0, 300, 300}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0001, heading 1 at 294,304, cost 153; axle at 300.0,299.5, 7.85 rad, 5505 ms
end 1000, heading 2 at -300,10, cost 203; axle at -298.3,0.0, 9.42 rad, 10980 ms
)");
}

TEST(LineWalkerTest, TakesBendsToTheLeft) {
  Walk walk({{-300, 0, 300, 0}, {300, 0, 300, -300}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0100, heading 3 at 294,-295, cost 153; axle at 300.0,-299.5, 4.71 rad, 5505 ms
end 1000, heading 2 at -309,-2, cost 203; axle at -298.4,0.0, 9.42 rad, 10980 ms
)");
}

TEST(LineWalkerTest, DrivesOverAGap) {
  Walk walk({{-300, 0, 200, 0}, {250, 0, 400, 0}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 400,5, cost 74; axle at 399.8,0.0, 6.28 rad, 3870 ms
end 1000, heading 2 at -298,0, cost 124; axle at -298.5,0.0, 9.42 rad, 7710 ms
)");
}

TEST(LineWalkerTest, TakesAWideGapForAnEnd) {
  Walk walk({{-300, 0, 200, 0}, {320, 0, 400, 0}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 199,4, cost 41; axle at 198.9,0.0, 6.28 rad, 3200 ms
end 1000, heading 2 at -298,-1, cost 90; axle at -298.3,0.0, 9.42 rad, 6370 ms
)");
}

TEST(LineWalkerTest, KnowsALoopWhenItIsRound) {
  Walk walk({{-200, 0, 400, 0}, {400, 0, 400, 400}, {400, 400, -200, 400}, {-200, 400, -200, 0}});
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
loop 0000, heading 0 at -99,3, cost 506; axle at -98.6,0.0, 12.56 rad, 12745 ms
)");
}

TEST(LineWalkerTest, KnowsHowLongALineOfAMinuteAndAHalfIs) {
  const int mm = 27000, mm_per_s = 300, units_per_s = 50;
  Walk walk({{-300, 0, mm, 0}});
  walk.walker.begin();
  const nav::Landmark end = walk.walker.follow();
  EXPECT_EQ(end.kind, nav::LandmarkKind::end);
  EXPECT_NEAR(end.at.x, mm, 30);
  EXPECT_NEAR(end.cost, mm * units_per_s / mm_per_s, 10);
}

TEST(LineWalkerTest, TurnsRoundAtAnEndFromWhichItFaces) {
  Walk walk({{-300, 0, 300, 0}});
  walk.robot.x = 300;
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
end 0010, heading 2 at 0,0, cost 0; axle at 300.0,0.0, 9.39 rad, 3390 ms
end 1000, heading 2 at -599,-5, cost 107; axle at -299.3,0.0, 9.42 rad, 5565 ms
)");
}

TEST(LineWalkerTest, StandsAsItStoodOnAJunctionWithNothingAhead) {
  Walk walk({{-300, 0, 0, 0}, {0, -300, 0, 300}});
  walk.go({kRight});
  EXPECT_EQ("\n" + Walk::said, R"(
junction 0111, heading 0 at 0,0, cost 25; axle at 0.0,0.0, 6.29 rad, 3390 ms
end 0001, heading 1 at 126,261, cost 67; axle at -0.5,299.5, 7.88 rad, 4765 ms
end 1000, heading 2 at 68,261, cost 17; axle at -57.9,300.8, 9.40 rad, 7960 ms
)");
}

TEST(LineWalkerTest, BeginsOnAJunction) {
  Walk walk({{0, 0, 300, 0}, {0, 0, 0, 300}, {-300, 0, 0, 0}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
junction 1110, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 299,4, cost 58; axle at 299.2,0.0, 6.28 rad, 3540 ms
junction 1110, heading 2 at 0,0, cost 57; axle at 0.5,0.3, 9.43 rad, 6045 ms
)");
}

TEST(LineWalkerTest, CountsItsHeadingAnewWhereItBeginsAnew) {
  Walk walk({{-300, 0, 300, 0}, {300, -300, 300, 300}});
  walk.go({kRight});
  Walk::said.clear();
  walk.tell(walk.walker.begin());
  EXPECT_EQ(Walk::said.substr(0, 27), "end 0010, heading 2 at 0,0,")
      << "the heading of the line behind the robot";
}

TEST(LineWalkerTest, BeginsAcrossALine) {
  Walk walk({{0, -300, 0, 300}});
  walk.robot.angle = 0.3;
  walk.robot.y = 5;
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 0101, heading 1 at 0,0, cost 0; axle at 0.0,5.0, 7.82 rad, 2625 ms
end 0001, heading 1 at -4,293, cost 56; axle at 0.0,298.7, 7.85 rad, 3780 ms
)");
}

TEST(LineWalkerTest, TakesAJumpOfTheLineForAJunction) {
  Walk walk({{-300, 0, 200, 0}, {200, 14, 500, 14}});
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1110, heading 0 at 208,7, cost 41; axle at 210.6,7.1, 6.41 rad, 3215 ms
)");
}

TEST(LineWalkerTest, LosesALineThatIsGone) {
  Walk walk({{-300, 0, 200, 0}, {200, 22, 500, 22}});
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
lost 0000, heading 1 at 208,4, cost 179; axle at 207.3,0.6, 7.81 rad, 6070 ms
)");
}

TEST(LineWalkerTest, FollowsASlant) {
  Walk walk({{-300, 0, 200, 0}, {200, 0, 380, 60}, {380, 60, 600, 60}});
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 600,53, cost 112; axle at 599.1,60.1, 6.29 rad, 4620 ms
end 1000, heading 2 at -299,3, cost 161; axle at -298.2,0.0, 9.42 rad, 9205 ms
)");
}

// Over the slant, the outer sensor gets as dark as over a junction's arm. But no more of the row of sensors
// is dark than a line alone can cover.
TEST(LineWalkerTest, FollowsALineThatComesUnderItsOuterSensorAslant) {
  for (const int length : {40, 80, 150, 300}) {
    const double slant = 36 * M_PI / 180, x = 200 + length * std::cos(slant), y = length * std::sin(slant);
    Walk walk({{-300, 0, 200, 0}, {200, 0, x, y}, {x, y, x + 400, y}});
    walk.walker.begin();
    EXPECT_EQ(walk.walker.follow().kind, nav::LandmarkKind::end) << length;
    EXPECT_NEAR(walk.robot.x, x + 400, 2) << length;
    EXPECT_NEAR(walk.robot.y, y, 2) << length;
  }
}

TEST(LineWalkerTest, MeetsALineAtAnAngle) {
  Walk walk({kTrunk, {200, -150, 400, 150}});
  walk.go({kOn});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1011, heading 0 at 288,4, cost 55; axle at 287.5,0.9, 6.28 rad, 3490 ms
end 0010, heading 0 at 598,5, cost 59; axle at 598.8,0.0, 6.28 rad, 4725 ms
)");
}

TEST(LineWalkerTest, CatchesUpWithWeakMotors) {
  Walk walk({kTrunk, {300, 0, 300, 300}});
  walk.robot.left_wheel = walk.robot.right_wheel = 0.8;
  walk.go({kRight});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2350 ms
junction 1110, heading 0 at 301,4, cost 57; axle at 299.6,0.2, 6.28 rad, 3520 ms
end 0001, heading 1 at 296,303, cost 57; axle at 300.0,299.0, 7.85 rad, 5500 ms
)");
}

TEST(LineWalkerTest, SteersAgainstUnequalMotors) {
  Walk walk({kTrunk, {300, 0, 300, 300}});
  walk.robot.left_wheel = 1.06;
  walk.robot.right_wheel = 0.9;
  walk.go({kRight, kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.4,0.2, 6.25 rad, 2350 ms
junction 1110, heading 0 at 300,5, cost 57; axle at 299.9,0.2, 6.27 rad, 3525 ms
end 0001, heading 1 at 297,303, cost 57; axle at 300.1,298.4, 7.84 rad, 5525 ms
junction 1110, heading 3 at 301,4, cost 57; axle at 299.9,1.0, 10.98 rad, 8040 ms
)");
}

TEST(LineWalkerTest, KeepsItsStepsThoughReadingTakesTime) {
  Walk walk({kTrunk});
  walk.robot.reading_us = 700;
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0010, heading 0 at 599,5, cost 107; axle at 598.9,0.0, 6.28 rad, 4536 ms
)");
}

TEST(LineWalkerTest, DoesNotRushAfterStepsThatTookTooLong) {
  Walk walk({kTrunk});
  walk.robot.reading_us = 6000;
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2832 ms
end 0010, heading 0 at 599,5, cost 108; axle at 598.6,0.0, 6.28 rad, 5467 ms
)");
}

TEST(LineWalkerTest, ComesBackFromBesideTheLine) {
  Walk walk({kTrunk, {300, 0, 300, 300}});
  walk.robot.y = -9;
  walk.robot.angle = -0.2;
  walk.go({kRight});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,-9.0, 6.38 rad, 2630 ms
junction 1110, heading 0 at 300,-11, cost 58; axle at 299.3,0.2, 6.28 rad, 3820 ms
end 0001, heading 1 at 295,288, cost 57; axle at 300.0,299.6, 7.85 rad, 5800 ms
)");
}

TEST(LineWalkerTest, FollowsARoundBend) {
  std::vector<walked::Line> lines{{-300, 0, 200, 0}};
  for (int i = 0; i < 15; ++i) {  // draws a quarter of a circle
    const double a = i * M_PI / 30, b = (i + 1) * M_PI / 30;
    lines.push_back({200 + 200 * sin(a), 200 - 200 * cos(a), 200 + 200 * sin(b), 200 - 200 * cos(b)});
  }
  lines.push_back({400, 200, 400, 400});
  Walk walk(lines);
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
end 0001, heading 1 at 404,397, cost 133; axle at 400.1,398.5, 7.85 rad, 5040 ms
end 1000, heading 2 at -283,-12, cost 183; axle at -299.4,0.0, 9.43 rad, 10055 ms
)");
}

TEST(LineWalkerTest, IsLostWhereThereIsNoLine) {
  Walk walk({{-300, 300, 300, 300}});
  const nav::Landmark lost = walk.walker.begin();
  EXPECT_EQ(lost.kind, nav::LandmarkKind::lost);
  EXPECT_EQ(lost.arms, 0);
  EXPECT_EQ(lost.heading, 0);
}

TEST(LineWalkerTest, MakesItsPinsWhatTheyAre) {
  Walk walk({kTrunk});
  const fake::Pin* pins = fake::board.pins;
  EXPECT_EQ(pins[walked::kBumper].mode, INPUT_PULLUP);
  for (const int pin : {walked::kLeftPwm, walked::kLeft1, walked::kLeft2, walked::kRightPwm, walked::kRight1,
                        walked::kRight2})
    EXPECT_EQ(pins[pin].mode, OUTPUT) << pin;
  EXPECT_TRUE(pins[walked::kLeftCounts].handler != nullptr && pins[walked::kRightCounts].handler != nullptr);
  walk.motors.drive(1, 1);
  EXPECT_EQ(pins[walked::kLeftPwm].duty, 20);
  EXPECT_EQ(pins[walked::kRightPwm].duty, 20);
}

TEST(LineWalkerTest, CountsOnFromWhereItIsToldThatItIs) {
  Walk walk({kTrunk, {300, 0, 300, 300}});
  walk.walker.begin();
  const nav::Landmark junction = walk.walker.follow();
  ASSERT_EQ(junction.kind, nav::LandmarkKind::junction);
  walk.walker.relocate({junction.at.x + 70, junction.at.y + 30});
  walk.walker.relocate({junction.at.x + 1000, junction.at.y - 500});
  walk.walker.leave(kOn);
  const nav::Landmark end = walk.walker.follow();
  EXPECT_NEAR(end.at.x, 1600, 5);
  EXPECT_NEAR(end.at.y, -500, 5);
}

TEST(LineWalkerParts, AWheelIsNeverDrivenAgainstTheWayItTurns) {
  using line_walker::dutyOf;
  EXPECT_EQ(dutyOf(100, 60), 60);
  EXPECT_EQ(dutyOf(100, -1), 0);
  EXPECT_EQ(dutyOf(-100, 1), 0);
  EXPECT_EQ(dutyOf(-100, -60), -60);
  EXPECT_EQ(dutyOf(0, 60), 0);
  EXPECT_EQ(dutyOf(0, -60), 0);
  EXPECT_EQ(dutyOf(100, 255.9f), 255);
  EXPECT_EQ(dutyOf(100, 1000), 255);
  EXPECT_EQ(dutyOf(-100, -1000), -255);
}

}  // namespace line_walker_test
