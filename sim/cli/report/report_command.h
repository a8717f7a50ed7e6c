// `robosim report`: what came of many runs, as a page for people.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Writes the page, and beside it a folder of replays. Gives 0. Throws InputError, ToolMissing.
int report_command(const ReportArguments& arguments);

}  // namespace robosim::cli
