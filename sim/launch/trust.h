// Checks whether this machine can confine a stranger's sketch (docs/explanation/security.md).
#pragma once

#include <string>
#include <vector>

#include "sim/launch/launch.h"

namespace robosim::launch {

/// Returns what this machine lacks for confinement, one sentence each. `host_runner` is robosim-host's own
/// description, and does not matter for chips. Throws ToolMissing if anything is missing and the launch is
/// untrusted.
std::vector<std::string> lacks(const Launch& launch, const Chosen& chosen, const wire::Hello& host_runner);

/// Checks an untrusted launch. Throws InputError for a link in the sketch's folder that leads out of it.
void check_folder(const SketchChoice& sketch);
/// Checks an untrusted launch. Throws InputError if a robot in the sketch's folder has a base outside of it.
void check_robot(const SketchChoice& sketch, const Choice& robot);

/// Returns the chip target of a launch without a target: that of a finished image, else of the robot's board.
std::string chip_target(const Launch& launch, const Describe& describe);

}  // namespace robosim::launch
