// Repeats a test with the power failing at every possible place.
#pragma once

#include <functional>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Runs `body`, which drives the robot and expects things as any test does: first as it is, then once more
/// for each byte that the sketch wrote to its EEPROM in that run, with the power off for 20 ms in the middle
/// of that write, and for each of three contents that its byte is left with: the old one, erased (0xFF), the
/// new one. What `body` expects must hold with and without a cut. Ends after the first run that fails; the
/// message names the write, and the command that replays the run.
///
///   AtEveryPowerCut({.sketch = "MyDiary"}, [](Simulation& robot) {
///     robot.run_for(2_s);
///     EXPECT_THAT(robot.serial(), Not(HasSubstr("nonsense")));
///   });
void AtEveryPowerCut(const Trial& trial, const std::function<void(Simulation&)>& body,
                     const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace robosim::testing
