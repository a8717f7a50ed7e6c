// Saves the files of a run whose test failed. docs/howto/testing.md lists them.
#pragma once

#include <string>

#include "sim/testing/request_builder.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {

/// The name of the saved page that replays the run in a browser.
inline constexpr const char* kPage = "run.html";

/// Returns the folder for the current test's next run. It is below the folder that the environment variable
/// ROBOSIM_ARTIFACTS names, or below ./robosim-artifacts. Returns "" if the variable is "none", and in silent
/// runs. Does not create the folder.
std::string artifact_folder();

/// Returns the robosim command that repeats a resolved trial, without --for. `script` selects whether the
/// command names a script file.
std::string replay_command(const ResolvedTrial& resolved_trial, const std::string& folder, bool script);

/// Creates the folder, and writes the files that the replay command names. Does nothing if `folder` is "".
void keep_inputs(const std::string& folder, const ResolvedTrial& resolved_trial, const std::string& script);

/// Returns the robosim command that repeats a run of several robots. The file that lists the robots is in
/// `folder`.
std::string replay_command(const FleetTrial& trial, const std::string& folder);
/// Writes the file that lists the robots, and all files that this list names. `scripts` are the robots'
/// scripts.
void keep_inputs(const std::string& folder, const launch::Fleet& fleet,
                 const std::vector<ResolvedTrial>& resolved_trials, const std::vector<std::string>& scripts);
/// Saves one robot's log as text files.
void keep_texts(const RunLog& log, const std::string& folder, const std::string& prefix);
/// Runs several robots again, and records the run. Returns an error message, or "" on success.
std::string record_again(const launch::Fleet& fleet, const std::vector<ResolvedTrial>& resolved_trials,
                         const std::vector<std::string>& scripts, const result::RunResult* expected,
                         std::int64_t until_ns, const std::string& folder, client::Runner& runner);

/// Runs one robot again without pauses, and writes the run's artifact folder. Returns an error message, or ""
/// on success.
std::string keep(const RunLog& log, const ResolvedTrial& resolved_trial, const std::string& script,
                 client::Runner& runner);

}  // namespace robosim::testing
