// The user's settings of a run, as the command line or a file of checks states them.
#pragma once

#include <string>
#include <vector>

#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"

namespace robosim::launch {

/// Names are as the user typed them; empty = not given.
struct RunSettings : Launch {
  Fleet fleet;                    ///< several robots; without members, the single robot of the base class
  std::string script;             ///< a file
  std::vector<std::string> send;  ///< texts in scenario syntax, between its double quotes
  bool chip_only = false;         ///< the default target is the chip of the robot's board, not the host
};

/// Settings that are still text: --for, --clock and --seed; empty = not given.
struct RunTexts {
  std::string duration, clock, seed;
};
/// Stores the texts in the settings, and checks the profile. Throws InputError.
void take(const RunTexts& texts, RunSettings& settings);

/// Returns the scenario's text: the file of `script`, then a line for each text of `send`. Throws InputError.
std::string scenario_text(const RunSettings& settings);

/// Returns the launch, with its scenario. Throws InputError.
Launch launch_of(const RunSettings& settings);

/// Copies each common setting to the robots of the fleet that do not have their own value. Throws InputError.
void fill_up(Fleet& fleet, const RunSettings& all);

}  // namespace robosim::launch
