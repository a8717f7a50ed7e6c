// `robosim report`: shows the results of many runs as a page.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Writes the page, and a folder of replays next to it. Returns 0. Throws InputError, ToolMissing.
int report_command(const ReportArguments& arguments);

}  // namespace robosim::cli
