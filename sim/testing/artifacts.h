// Saves the files of a run whose test failed. docs/howto/testing.md lists them.
#pragma once

#include <string>

#include "sim/testing/request_builder.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {

/// The file in the folder that a browser opens.
inline constexpr const char* kPage = "run.html";

/// Returns the folder for the current test's next run, below ROBOSIM_ARTIFACTS or ./robosim-artifacts; "" if
/// that is "none", and in silent runs. Does not create it.
std::string artifact_folder();

/// Returns the robosim command for a resolved trial, without --for; `script` is its file, or empty.
std::string replay_command(const ResolvedTrial& resolved_trial, const std::string& folder, bool script);

/// Creates the folder, and writes the files that the command names. Does nothing if `folder` is "".
void keep_inputs(const std::string& folder, const ResolvedTrial& resolved_trial, const std::string& script);

/// Returns the command for several robots, whose file is in the folder.
std::string replay_command(const FleetTrial& trial, const std::string& folder);
/// Writes that file and the files that it names; `scripts` are those of the robots.
void keep_inputs(const std::string& folder, const launch::Fleet& fleet,
                 const std::vector<ResolvedTrial>& resolved_trials, const std::vector<std::string>& scripts);
/// Saves one robot's texts for the test's reader.
void keep_texts(const RunLog& log, const std::string& folder, const std::string& prefix);
/// Runs several robots again, with a recording. Returns what went wrong, or "".
std::string record_again(const launch::Fleet& fleet, const std::vector<ResolvedTrial>& resolved_trials,
                         const std::vector<std::string>& scripts, const wire::RunResult* expected,
                         std::int64_t until_ns, const std::string& folder, client::Runner& runner);

/// Runs it again without stops, and writes the folder. Returns what went wrong, or "".
std::string keep(const RunLog& log, const ResolvedTrial& resolved_trial, const std::string& script,
                 client::Runner& runner);

}  // namespace robosim::testing
