// What a test run tells machines: JUnit properties, GitHub annotations and its summary.
#pragma once

#include <string>

#include "sim/testing/run_log.h"

namespace robosim::testing {

/// The run's figures as properties of the current test: Google Test writes them into its XML (JUnit).
void record_figures(const RunLog& log, const wire::RunResult& result);

/// Of all runs of the current test that have ended, those of a search too: the sum of their trace hashes. Any
/// run that is different makes it another.
void record_trace(const std::string& trace_hash);

/// The folder in which a run of the current test is kept: the property names all of them.
void record_kept(const std::string& folder);

/// Where GITHUB_ACTIONS is set: from now on each failure is also an annotation of its line, and at the end a
/// table is appended to the file GITHUB_STEP_SUMMARY. Once is enough.
void report_to_github();

}  // namespace robosim::testing
