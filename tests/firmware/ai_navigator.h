// Runs AiNavigator on a test's floor: starts a scan, and sends the robot to stations.
#pragma once

#include <robosim/testing.h>

#include <optional>

namespace robosim::testing {

class AiNavigatorAgain : public ::testing::Test {
 protected:
  void put_on(const char* map, const std::string& start = "", const std::string& robot = "") {
    robot_.emplace(Trial{.sketch = "AiNavigator", .map = map, .robot = robot, .start = start});
  }
  Simulation& robot() { return *robot_; }
  void scan() {
    ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
    robot().press("start");
    ASSERT_TRUE(robot().run_until(serial_says("destination?"), within(5_min)));
  }
  Drive go_to(const std::string& station) {
    robot().send(station + "\n");
    return robot().run_until(serial_says("arrived at " + station), within(2_min));
  }

 private:
  std::optional<Simulation> robot_;
};

}  // namespace robosim::testing
