// Runs a simulation that branches (wire::Ways). The common part runs once. Each branch, called a way,
// continues in a copy of the process; the first way continues in this process. A copy has all state: chip,
// world, detectors, and line counts.
//
//   this process:  power-on ────────────► split ──── the first way ────► its result, with the others'
//                                           │ fork
//                                           ├──────── the second way ────► its result
//                                           └ …
#pragma once

#include <functional>

#include "sim/runner/requested_run.h"

namespace robosim::runner {

/// Runs the ways of the request one after the other; the first way runs last. The request must have ways.
/// Each copy of the process first calls `in_copy`. An empty `in_copy` means that this process cannot be
/// copied, because host firmware is confined. Each way writes its line counters if the request asks for them.
/// Throws InputError if the run cannot branch, or a way's script is invalid.
result::RunResult run_all_branches(RequestedRun& run, const wire::RunRequest& request,
                                   const std::function<void()>& in_copy);

}  // namespace robosim::runner
