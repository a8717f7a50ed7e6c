// Runs tests without reporting their failures: a search tries many runs, and reports only one.
#pragma once

#include <functional>
#include <string>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Returns whether a silent run is in progress. Silent runs save no files and record no values.
bool is_silent_run();

/// Runs `body` silently, and returns whether it fails or throws. Throws InputError or ToolMissing if no run
/// took place: the sketch does not compile, or the trial names something that does not exist.
bool fails_in(const Trial& trial, const std::function<void(Simulation&)>& body);

/// Runs `body` and reports its failures, which fail the test. Prints `why` after them.
void rerun_and_report(const Trial& trial, const std::function<void(Simulation&)>& body,
                      const std::string& why, const char* file, int line);

}  // namespace robosim::testing
