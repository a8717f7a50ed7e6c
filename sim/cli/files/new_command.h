// `robosim new NAME`: creates a working project as a starting point.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Creates the folder NAME from the templates in sim/cli/files/new (installed: share/robosim/new). The
/// project's name replaces NAME in the files' names and texts. Never overwrites a file. Throws InputError.
int new_command(const NewArguments& arguments);

}  // namespace robosim::cli
