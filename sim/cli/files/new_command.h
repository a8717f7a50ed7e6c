// `robosim new NAME`: creates a working project as a starting point.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Creates a project's folder from the templates in sim/cli/files/new (installed: share/robosim/new).
/// Replaces the word NAME in their file names and texts by the project's name. Never overwrites a file.
/// Throws InputError.
int new_command(const NewArguments& arguments);

}  // namespace robosim::cli
