// Writes machine-readable reports of a test run: JUnit properties, GitHub annotations and GitHub's summary.
#pragma once

#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// Records measurements of the run as properties of the current test. Google Test writes the properties to
/// its XML file (JUnit).
void record_figures(const RunLog& log, const result::RunResult& result);

/// Adds a hash to the sum of the trace hashes of the current test. The sum covers all finished runs,
/// including those of a search, and changes with any difference in a run.
void record_trace(const std::string& trace_hash);

/// Records the artifact folder of a run of the current test. One property lists all such folders.
void record_kept(const std::string& folder);

/// Reports failures to GitHub if the environment variable GITHUB_ACTIONS is set. Each later failure also
/// becomes an annotation of its source line. At the end, a table is appended to the file that the variable
/// GITHUB_STEP_SUMMARY names. Further calls do nothing.
void report_to_github();

}  // namespace robosim::testing
