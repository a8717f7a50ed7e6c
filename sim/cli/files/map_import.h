// `robosim map import`: imports courses of other tools (docs/reference/courses.md).
#pragma once

#include <iosfwd>

#include "sim/cli/arguments.h"
#include "sim/cli/output.h"

namespace robosim::cli {

/// Writes the map to the file of --out and reports its content. Without --out, writes the map to `out`. Never
/// overwrites a file.
ExitStatus import_map(const ImportArguments& arguments, std::ostream& out);

int import_command(const ImportArguments& arguments);

}  // namespace robosim::cli
