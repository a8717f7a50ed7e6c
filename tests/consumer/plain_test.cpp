// Tests a plain function of the sketch, without a robot.
#include <gtest/gtest.h>

#include "Follower/steering.h"

TEST(Steering, GoesTowardsTheDarkerSide) {
  EXPECT_EQ(steer(500, 500), 0);
  EXPECT_GT(steer(100, 900), 0);
  EXPECT_LT(steer(900, 100), 0);
}

TEST(Steering, KeepsToTheRangeOfAnalogWrite) {
  EXPECT_EQ(steer(0, 32767), 255);
  EXPECT_EQ(steer(32767, 0), -255);
}
