// Creates the files that `robosim run` writes.
#pragma once

#include <vector>

#include "sim/base/file_lock.h"
#include "sim/cli/arguments.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// Returns the recorders of --record and --plot. Throws InputError.
record::Recorders recorders_of(const RunArguments& arguments);
/// Locks the files of --record and --plot, so that no other process writes them at the same time. Throws
/// InputError.
std::vector<FileLock> claims_of(const RunArguments& arguments);

/// Returns a line for each file that a run has written: "run.html is written; open it in a browser".
std::string written_text(const std::vector<std::string>& files);
std::string written_text(const RunArguments& arguments);

}  // namespace robosim::cli
