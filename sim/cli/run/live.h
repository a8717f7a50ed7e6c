// `robosim run --live`: executes a run in step with the wall clock, controlled by a web page or another
// program. That program sends requests as lines of JSON on the standard input (sim/wire/live.h), at any time.
// Reports are lines on the standard output, about 60 times a second.
//
// The first report is `recording`, the header of the run's recording. The runner's events follow. After each
// frame, the report `paused` contains the run's state. The last report is the `result`. The run begins
// paused, and ends at the end of the standard input.
#pragma once

#include "sim/launch/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// Executes the run and returns its result. `on_event` also receives the runner's events.
result::RunResult run_live(client::Runner& runner, const record::RecordedRun& run,
                           const wire::OnEvent& on_event);

}  // namespace robosim::cli
