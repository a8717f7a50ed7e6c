// A run that branches (wire::Ways). The common part runs once, and each way continues in a copy of this
// process. That copies all state: chip, world, detectors, and line counts.
//
//   this process:  power-on ────────────► parts ──── the first way ────► its result, with the others'
//                                           │ fork
//                                           ├──────── the second way ────► its result
//                                           └ …
#pragma once

#include <functional>

#include "sim/runner/requested_run.h"

namespace robosim::runner {

/// Runs the ways one after the other, in the order of the request, which has some. `in_copy`: called first in
/// each copy; empty: this process cannot be copied, as host firmware is confined. Each way writes its
/// counters, if the request asks for some. Throws InputError if such a run cannot branch, or a way's script
/// is invalid.
wire::RunResult run_all_branches(RequestedRun& run, const wire::RunRequest& request,
                                 const std::function<void()>& in_copy);

}  // namespace robosim::runner
