// `robosim test`: runs the checks of one or more sketches, several runs at a time.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status. Throws InputError for errors outside of sketches.
int test_command(const TestArguments& arguments);

}  // namespace robosim::cli
