// Defines the user's settings of a run, as given on the command line or in a file of checks.
#pragma once

#include <string>
#include <vector>

#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"

namespace robosim::launch {

/// Names are as the user typed them; empty = not given.
struct RunSettings : Launch {
  Fleet fleet;                    ///< several robots; if it has no members, `Launch` describes the only robot
  std::string script;             ///< path of the script file
  std::vector<std::string> send;  ///< texts to send to the firmware at 1 s, with the escapes of a script
  bool chip_only = false;         ///< the default target is the chip of the robot's board, not the host
};

/// Settings that are still text: --for, --clock and --seed; empty = not given.
struct RunTexts {
  std::string duration, clock, seed;
};
/// Converts the texts, stores the values in the settings, and checks request.profile. Throws InputError.
void take(const RunTexts& texts, RunSettings& settings);

/// Returns the script's text: the content of the file `script`, then a line for each text of `send`. Throws
/// InputError.
std::string scenario_text(const RunSettings& settings);

/// Returns the launch, with its script's text. Throws InputError.
Launch launch_of(const RunSettings& settings);

/// Copies the settings that all robots share to each robot of the fleet. A robot's own value takes
/// precedence. Throws InputError.
void fill_up(Fleet& fleet, const RunSettings& all);

}  // namespace robosim::launch
