// `robosim calibrate`: figures of a robot file from logs of the real robot (docs/calibrating.md).
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// `words` after "calibrate". Throws InputError.
Command parse_calibrate(const std::vector<std::string>& words);

/// Says what the logs tell, and writes it if a file is named for it. Throws InputError; then nothing is
/// written.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace robosim::cli
