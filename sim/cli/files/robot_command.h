// `robosim robot list|show|check`: lists the stock robots, prints or checks a robot file.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status. Throws InputError and wire::RunnerError.
int robot_command(const RobotArguments& arguments);

}  // namespace robosim::cli
