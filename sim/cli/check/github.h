// Output of `robosim test` for GitHub Actions: notes at lines of files, and a summary of the job.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/check/check_result.h"

namespace robosim::cli {

/// Returns whether the program runs in GitHub Actions: GITHUB_ACTIONS is "true".
bool on_github();

/// Returns a line `::error file=…,line=…::…` for each failure. It names the place of the [[check]], or a line
/// of the sketch.
std::string github_notes(const std::vector<campaign::SketchResult>& sketches);

/// Returns a Markdown table with a row for each check of each sketch.
std::string github_summary(const std::vector<campaign::SketchResult>& sketches);

/// Appends the summary to the file that the variable GITHUB_STEP_SUMMARY names, if it is set. Throws
/// InputError if the file cannot be written.
void add_github_summary(const std::vector<campaign::SketchResult>& sketches);

}  // namespace robosim::cli
