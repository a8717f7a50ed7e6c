// Repeats a test with a power failure at every write to the EEPROM.
#pragma once

#include <functional>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Runs `body` first without a power cut. `body` drives the robot and contains expectations, like any test.
/// Then repeats the run for each write of a byte to the EEPROM. In the middle of this write, the power goes
/// off for 20 ms. Each cut is repeated with three contents of the byte: the old value, erased (0xFF), and the
/// new value.
///
/// The expectations of `body` must hold with and without a cut. Ends after the first run that fails. The
/// message names the write, and the command that replays the run.
///
///   AtEveryPowerCut({.sketch = "MyDiary"}, [](Simulation& robot) {
///     robot.run_for(2_s);
///     EXPECT_THAT(robot.serial(), Not(HasSubstr("nonsense")));
///   });
void AtEveryPowerCut(const Trial& trial, const std::function<void(Simulation&)>& body,
                     const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace robosim::testing
