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

/// Runs it once more, in one go, and writes the folder. Returns what went wrong, or "".
std::string keep(const RunLog& log, const Stage& stage, const std::string& script, client::Runner& runner);

}  // namespace robosim::testing
