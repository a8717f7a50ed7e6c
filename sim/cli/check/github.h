// Output of `robosim test` for GitHub Actions: notes at lines of files, and a summary of the job.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/check/check_result.h"

namespace robosim::cli {

/// Returns whether the program runs in GitHub Actions: GITHUB_ACTIONS is "true".
bool on_github();

/// Returns a `::error file=…,line=…::…` for each failure, at its [[check]] or at the place in the sketch.
std::string github_notes(const std::vector<campaign::SketchResult>& sketches);

/// Returns a Markdown table.
std::string github_summary(const std::vector<campaign::SketchResult>& sketches);

/// Appends the summary to the file in GITHUB_STEP_SUMMARY, if that is set. Throws InputError.
void add_github_summary(const std::vector<campaign::SketchResult>& sketches);

}  // namespace robosim::cli
