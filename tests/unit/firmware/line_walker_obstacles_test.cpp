// Tests LineWalker with obstacles on its line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "line_walk.h"

namespace line_walker_obstacles_test {

using namespace walked;

TEST(LineWalkerTest, WaitsForAnObstacleAndGoesOn) {
  Walk walk({kTrunk});
  walk.robot.wall_x = 300;
  walk.robot.wall_ms = 1500;
  walk.go({});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; goes on; end 0010, heading 0 at 599,5, cost 112; axle at 598.5,0.0, 6.28 rad, 6626 ms
)");
}

TEST(LineWalkerTest, BacksUpBeforeAnObstacleThatStays) {
  Walk walk({kTrunk});
  walk.robot.wall_x = 300;
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; blocked 0010, heading 0 at 221,4, cost 71; axle at 185.7,0.0, 6.28 rad, 7825 ms
end 1000, heading 2 at -299,-1, cost 88; axle at -299.3,0.0, 9.42 rad, 10950 ms
)");
}

TEST(LineWalkerTest, BacksUpToABend) {
  Walk walk({{-300, 0, 300, 0}, {300, 0, 300, 300}, {300, 300, 900, 300}});
  walk.robot.wall_x = 400;
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; blocked 0010, heading 0 at 294,304, cost 217; axle at 300.5,299.1, 6.30 rad, 10860 ms
end 1000, heading 2 at -308,10, cost 203; axle at -298.2,0.0, 3.14 rad, 15845 ms
)");
}

TEST(LineWalkerTest, StandsBeforeAnObstacleOnAJunction) {
  Walk walk({kTrunk, {200, 0, 200, 300}});
  walk.robot.wall_x = 225;
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; blocked 0010, heading 0 at 146,3, cost 58; axle at 110.5,0.0, 6.29 rad, 7575 ms
end 1000, heading 2 at -300,-1, cost 76; axle at -299.7,0.0, 9.42 rad, 10450 ms
)");
}

TEST(LineWalkerTest, StandsBeforeAnObstacleInTheMiddleOfAnArm) {
  Walk walk({kTrunk, {200, 0, 200, 300}});
  walk.robot.wall_x = 205;
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; blocked 0010, heading 0 at 126,3, cost 55; axle at 91.0,-0.2, 6.29 rad, 7510 ms
end 1000, heading 2 at -298,-2, cost 72; axle at -298.4,0.0, 9.42 rad, 10305 ms
)");
}

TEST(LineWalkerTest, BacksUpFromAnObstacleAtAnEnd) {
  Walk walk({{-300, 0, 300, 0}});
  walk.robot.wall_x = 365;
  walk.go({kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
stands; end 0010, heading 0 at 286,4, cost 82; axle at 250.5,0.0, 6.28 rad, 8050 ms
end 1000, heading 2 at -299,-1, cost 99; axle at -298.9,0.0, 9.43 rad, 11390 ms
)");
}

TEST(LineWalkerTest, BacksUpToAJunctionThatItHasLeft) {
  Walk walk({kTrunk, {200, 0, 200, 300}});
  walk.robot.wall_x = 310;
  walk.go({kOn, kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1110, heading 0 at 201,4, cost 41; axle at 199.8,0.3, 6.28 rad, 3205 ms
stands; blocked 0010, heading 0 at 201,4, cost 35; axle at 199.7,0.2, 6.28 rad, 7980 ms
junction 1110, heading 2 at 201,4, cost 0; axle at 199.7,0.2, 9.39 rad, 9315 ms
)");
}

TEST(LineWalkerTest, BacksUpToAJunctionAndGoesAnotherWay) {
  Walk walk({kTrunk, {200, 0, 200, 300}});
  walk.robot.wall_x = 310;
  walk.go({kOn, kRight});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1110, heading 0 at 201,4, cost 41; axle at 199.8,0.3, 6.28 rad, 3205 ms
stands; blocked 0010, heading 0 at 201,4, cost 35; axle at 199.7,0.2, 6.28 rad, 7980 ms
junction 1110, heading 1 at 201,4, cost 0; axle at 199.7,0.2, 7.82 rad, 8800 ms
)");
}

TEST(LineWalkerTest, BacksUpOnlyALittleBehindAJunctionThatItHasLeft) {
  Walk walk({kTrunk, {200, 0, 200, 300}});
  walk.robot.wall_x = 395;
  walk.go({kOn, kBack});
  EXPECT_EQ("\n" + Walk::said, R"(
line 1010, heading 0 at 0,0, cost 0; axle at 0.0,0.0, 6.25 rad, 2360 ms
junction 1110, heading 0 at 201,4, cost 41; axle at 199.8,0.3, 6.28 rad, 3205 ms
stands; blocked 0010, heading 0 at 316,4, cost 53; axle at 280.7,0.1, 6.28 rad, 8340 ms
junction 1110, heading 2 at 198,1, cost 21; axle at 197.2,2.8, 9.47 rad, 10070 ms
)");
}

// The bumper may still touch the obstacle while the robot turns away from it.
TEST(LineWalkerTest, DoesNotWaitForAnObstacleFromWhichItTurnsAway) {
  for (const int wall : {310, 395}) {  // an obstacle near the junction, and one beyond it
    Walk walk({kTrunk, {200, 0, 200, 300}});
    walk.robot.wall_x = wall;
    walk.go({kOn});
    ASSERT_THAT(Walk::said, testing::HasSubstr("stands; blocked")) << wall;
    Walk::said.clear();
    walk.robot.wall_x = -1000;
    walk.walker.leave(kBack);
    EXPECT_EQ(Walk::said, "") << wall;
    EXPECT_NEAR(walk.robot.angle, 3 * M_PI, 0.3) << wall;
  }
}

}  // namespace line_walker_obstacles_test
