// Runs whose failures are not reported: a search tries many, and reports one.
#pragma once

#include <functional>
#include <string>

#include "robosim/testing/simulation.h"

namespace robosim::testing {

/// Whether a rehearsal is going on: its runs keep nothing and record no figures.
bool is_rehearsal();

/// Whether the body fails, or throws, in such a run; nothing is reported. Throws InputError or ToolMissing
/// where there was no run: the sketch does not compile, or the trial asks for what does not exist.
bool fails_in(const Trial& trial, const std::function<void(Simulation&)>& body);

/// The same, reported: what fails, fails the test, with `why` below it.
void run_for_all_to_see(const Trial& trial, const std::function<void(Simulation&)>& body,
                        const std::string& why, const char* file, int line);

}  // namespace robosim::testing
