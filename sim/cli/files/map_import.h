// `robosim map import`: imports courses of other tools (docs/reference/courses.md).
#pragma once

#include <iosfwd>

#include "sim/cli/arguments.h"
#include "sim/cli/output.h"

namespace robosim::cli {

/// Writes the map as a file, and reports its content; without --out to `out`. Nothing is overwritten.
ExitStatus import_map(const ImportArguments& arguments, std::ostream& out);

int import_command(const ImportArguments& arguments);

}  // namespace robosim::cli
