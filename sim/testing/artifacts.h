// What is kept of a run whose test failed: docs/testing.md lists it.
#pragma once

#include <string>

#include "sim/testing/run_log.h"
#include "sim/testing/stage.h"

namespace robosim::testing {

/// The file in it that a browser opens.
inline constexpr const char* kPage = "run.html";

/// The folder for the current test's next run, below ROBOSIM_ARTIFACTS or ./robosim-artifacts; "" if that is
/// "none", and in rehearsals. Nothing is made yet.
std::string artifact_folder();

/// The robosim command for a stage, but for --for; `script` is its file, or empty.
std::string replay_command(const Stage& stage, const std::string& folder, bool script);

/// Writes the files that the command names, and makes the folder. Does nothing if `folder` is "".
void keep_inputs(const std::string& folder, const Stage& stage, const std::string& script);

/// The same of several robots: their file is in the folder.
std::string replay_command(const FleetTrial& trial, const std::string& folder);
/// Writes that file and what it names; `scripts` are those of the robots.
void keep_inputs(const std::string& folder, const launch::Fleet& fleet, const std::vector<Stage>& stages,
                 const std::vector<std::string>& scripts);
/// What is kept of one of them, for the test's reader.
void keep_texts(const RunLog& log, const std::string& folder, const std::string& prefix);
/// Runs several once more, and records them. Returns what went wrong, or "".
std::string record_again(const launch::Fleet& fleet, const std::vector<Stage>& stages,
                         const std::vector<std::string>& scripts, const wire::RunResult* expected,
                         std::int64_t until_ns, const std::string& folder, client::Runner& runner);

/// Runs it once more, in one go, and writes the folder. Returns what went wrong, or "".
std::string keep(const RunLog& log, const Stage& stage, const std::string& script, client::Runner& runner);

}  // namespace robosim::testing
