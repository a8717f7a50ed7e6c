// What GitHub Actions shows of `robosim test`: notes at lines of files, and a summary of the job.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/check/check_result.h"

namespace robosim::cli {

/// Whether the program runs there: GITHUB_ACTIONS is "true".
bool on_github();

/// A `::error file=…,line=…::…` for each failure, at its [[check]] or at the place in the sketch.
std::string github_notes(const std::vector<SketchResult>& sketches);

/// A Markdown table.
std::string github_summary(const std::vector<SketchResult>& sketches);

/// Appends the summary to the file that GITHUB_STEP_SUMMARY names, if it does. Throws InputError.
void add_github_summary(const std::vector<SketchResult>& sketches);

}  // namespace robosim::cli
