// Checks whether this machine can confine a stranger's sketch (docs/explanation/security.md).
#pragma once

#include <string>
#include <vector>

#include "sim/launch/launch.h"

namespace robosim::launch {

/// Returns a sentence for each kind of confinement that this machine lacks. `host_runner` is the first
/// message of robosim-host; it is ignored for chip targets. Throws ToolMissing if any confinement is missing
/// and the launch is untrusted.
std::vector<std::string> lacks(const Launch& launch, const Chosen& chosen, const wire::Hello& host_runner);

/// Checks an untrusted launch. Throws InputError if the project or image refers to a folder outside the
/// sketch's folder.
void check_folder(const SketchChoice& sketch);
/// Checks an untrusted launch. Throws InputError if a robot in the sketch's folder has a base outside that
/// folder.
void check_robot(const SketchChoice& sketch, const Choice& robot);

/// Returns the chip target of a launch without a target: the target of the finished image, or else the target
/// of the robot's board.
std::string chip_target(const Launch& launch, const Describe& describe);

}  // namespace robosim::launch
