// `robosim man`: manual pages to standard output, or all of them into a folder.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

int man_command(const ManArguments& arguments);

}  // namespace robosim::cli
