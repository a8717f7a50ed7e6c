// `robosim run --live`: a run in step with the wall clock, for a page or another program. Requests are lines
// of JSON on the standard input (sim/wire/live.h), at any time. Reports are lines on the standard output,
// some 60 times a second. The first is `recording`, a recording's header of the run. Then come the runner's
// events, and `paused` at each pause; the last is the `result`. It begins paused, and ends with the standard
// input.
#pragma once

#include "sim/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// `on_event` receives the events, too.
wire::RunResult run_live(client::Runner& runner, const record::RecordedRun& run,
                         const wire::OnEvent& on_event);

}  // namespace robosim::cli
