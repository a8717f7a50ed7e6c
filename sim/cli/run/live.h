// `robosim run --live`: a run that goes along with the wall clock, for a page or another program. It is asked
// by lines of JSON on the standard input (sim/wire/live.h), at any time, and tells by lines on the standard
// output, some 60 times a second: first `recording`, what a recording's header holds of the run; then the
// runner's events and, wherever it stands, `paused`; at last the `result`. It begins standing still, and ends
// with the standard input.
#pragma once

#include "sim/client/runner.h"
#include "sim/record/recorder.h"

namespace robosim::cli {

/// `on_event` hears the events, too.
wire::RunResult run_live(client::Runner& runner, const record::RecordedRun& run,
                         const wire::OnEvent& on_event);

}  // namespace robosim::cli
