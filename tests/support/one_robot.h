// A run of one robot on a map, with default values that suit most tests.
#pragma once

#include <string>

#include "sim/robot/description.h"
#include "sim/run/simulation.h"

namespace robosim::test {

struct OneRobot {
  /// An empty `goal` selects the map's goal.
  explicit OneRobot(exec::Executor& firmware, const char* goal = "none", const std::string& script = "",
                    const char* robot_name = "uno5", const char* map_name = "oval")
      : robot(robot::load_description(robot_name)), map(map::read_map(map::find_map(map_name))) {
    setup.map = &map;
    setup.agents = {
        {.robot = &robot, .executor = &firmware, .scenario = scenario::parse_scenario(script, "s.txt")}};
    if (*goal) setup.agents[0].goal = judge::parse_goal(goal);
  }
  OneRobot(const OneRobot&) = delete;
  OneRobot& operator=(const OneRobot&) = delete;

  judge::Outcome run(SimTime limit) {
    setup.limit = limit;
    return run::simulate(setup).front();
  }

  robot::Description robot;
  map::Map map;
  run::Setup setup;
};

}  // namespace robosim::test
