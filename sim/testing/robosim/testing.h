// Provides tests that read like requirements, for line-follower firmware: docs/howto/testing.md.
//
//   #include <robosim/testing.h>
//   using namespace robosim::testing;
//
//   TEST(MyFollower, KeepsToTheLineForALap) {
//     Simulation robot({.sketch = "MyFollower", .map = "oval", .goal = "laps:1"});
//     EXPECT_THAT(robot.run_to_the_end(), AllOf(Reaches("laps:1"), Follows(line(), within(20_mm))));
//   }
//
// Time is simulated: no test waits, and each test gives the same result on every run.
#pragma once

#include "robosim/testing/drive.h"
#include "robosim/testing/events.h"
#include "robosim/testing/fleet.h"
#include "robosim/testing/graph.h"
#include "robosim/testing/matchers.h"
#include "robosim/testing/parameters.h"
#include "robosim/testing/power_cuts.h"
#include "robosim/testing/quantities.h"
#include "robosim/testing/robot_test.h"
#include "robosim/testing/simulation.h"
#include "robosim/testing/success_rate.h"
