// `robosim wire`
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The process's exit status: 0 where a draft was made, however good it is. Throws as `run` does.
int wire_command(const WireArguments& arguments);

}  // namespace robosim::cli
