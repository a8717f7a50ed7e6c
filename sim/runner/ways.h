// A run that parts (wire::Ways): up to there it is made once, and each way goes on in a copy of this process,
// which is all that there is to save: chip, world, detectors, and what counts lines.
//
//   this process:  power-on ────────────► parts ──── the first way ────► its result, with the others'
//                                           │ fork
//                                           ├──────── the second way ────► its result
//                                           └ …
#pragma once

#include <functional>

#include "sim/runner/requested_run.h"

namespace robosim::runner {

/// One after the other, in the order of the request, which has ways. `in_copy`: what each copy begins with;
/// empty: this process cannot be copied, as firmware on the host is shut in.
/// Each writes its counters, if the request asks for some. Throws InputError if a run like this cannot part,
/// or a way's script makes no sense.
wire::RunResult go_all_ways(RequestedRun& run, const wire::RunRequest& request,
                            const std::function<void()>& in_copy);

}  // namespace robosim::runner
