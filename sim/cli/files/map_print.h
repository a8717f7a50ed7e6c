// `robosim map print`: writes a PDF that prints a floor in true size.
#pragma once

#include <iosfwd>

#include "sim/cli/arguments.h"
#include "sim/cli/output.h"

namespace robosim::cli {

/// Writes the PDF, and reports its content. Never overwrites a file. Throws InputError.
ExitStatus print_map(const PrintArguments& arguments, std::ostream& out);

int print_command(const PrintArguments& arguments);

}  // namespace robosim::cli
