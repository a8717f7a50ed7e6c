// Machine-readable reports of a test run: JUnit properties, GitHub annotations and its summary.
#pragma once

#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// Records the run's values as properties of the current test; Google Test writes them to its XML (JUnit).
void record_figures(const RunLog& log, const wire::RunResult& result);

/// Adds to the sum of the trace hashes of all finished runs of the current test, including those of a search.
/// Any difference in a run changes the sum.
void record_trace(const std::string& trace_hash);

/// Records the folder of a run of the current test; the property names all of them.
void record_kept(const std::string& folder);

/// If GITHUB_ACTIONS is set: from now on each failure is also an annotation of its line. At the end a table
/// is appended to the file GITHUB_STEP_SUMMARY. Call it once.
void report_to_github();

}  // namespace robosim::testing
