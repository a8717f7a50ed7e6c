// `robosim run --live`: a run in step with the wall clock, for a page or another program. Requests are lines
// of JSON on the standard input (sim/wire/live.h), at any time. Reports are lines on the standard output,
// about 60 times a second. The first report is `recording`, the header of the run's recording. The runner's
// events follow, with `paused` at each pause; the last report is the `result`. The run begins paused, and
// ends at the end of the standard input.
#pragma once

#include "sim/launch/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// `on_event` also receives the events.
result::RunResult run_live(client::Runner& runner, const record::RecordedRun& run,
                           const wire::OnEvent& on_event);

}  // namespace robosim::cli
