// Runs whose failures are not reported: a search tries many, and reports one.
#pragma once

#include <functional>
#include <string>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Returns whether a silent run is in progress: its runs save no files and record no values.
bool is_silent_run();

/// Returns whether the body fails, or throws, in such a run; reports nothing. Throws InputError or
/// ToolMissing if there was no run: the sketch does not compile, or the trial names something that does not
/// exist.
bool fails_in(const Trial& trial, const std::function<void(Simulation&)>& body);

/// Runs the body with its failures reported: they fail the test, with `why` below them.
void rerun_and_report(const Trial& trial, const std::function<void(Simulation&)>& body,
                      const std::string& why, const char* file, int line);

}  // namespace robosim::testing
