// `robosim test`: the checks of one sketch or of many, all their runs through one pool.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The process's exit status. Throws InputError for what no sketch is to blame for.
int test_command(const TestArguments& arguments);

}  // namespace robosim::cli
