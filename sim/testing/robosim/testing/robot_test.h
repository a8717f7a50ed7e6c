// Defines a test fixture with one robot.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Creates a robot for each test, and skips the test if the target's tools are missing.
///
///   class Follower : public RobotTest {
///    protected:
///     Follower() : RobotTest({.sketch = "MyFollower", .map = "oval"}) {}
///   };
///   TEST_F(Follower, StartsAtOnce) { ASSERT_TRUE(robot().run_until(motors_start(), within(100_ms))); }
class RobotTest : public ::testing::Test {
 protected:
  explicit RobotTest(Trial trial) : trial_(std::move(trial)) {}

  void SetUp() override {
    ROBOSIM_SKIP_WITHOUT(trial_.target);
    robot_ = std::make_unique<Simulation>(trial_);
  }

  Simulation& robot() { return *robot_; }

 private:
  Trial trial_;
  std::unique_ptr<Simulation> robot_;
};

}  // namespace robosim::testing
