// `robosim man`: writes one manual page to standard output, or all pages into a folder.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

int man_command(const ManArguments& arguments);

}  // namespace robosim::cli
