// Whether this machine can confine somebody else's sketch (docs/security.md).
#pragma once

#include <string>
#include <vector>

#include "sim/launch/launch.h"

namespace robosim::launch {

/// What this machine lacks to confine that, a sentence each; `host_runner` is what robosim-host says of
/// itself, and does not count for the chips. Throws ToolMissing where anything is lacking and the launch is
/// untrusted.
std::vector<std::string> lacks(const Launch& launch, const Chosen& chosen, const wire::Hello& host_runner);

/// Of an untrusted launch. Throws InputError for a link in the sketch's folder that leads out of it.
void check_folder(const SketchChoice& sketch);

/// The chip target of a launch that names none: the one of a finished image, else of the robot's board.
std::string chip_target(const Launch& launch, const Describe& describe);

}  // namespace robosim::launch
