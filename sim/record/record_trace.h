// Recordings as .perfetto.json: a run as a trace, for ui.perfetto.dev and chrome://tracing. The format is
// "Trace Event Format" (Chromium's, JSON object form); docs/recordings.md says what is in it.
#pragma once

#include <string>

#include "sim/record/record_page.h"

namespace robosim::record {

class TraceRecorder final : public RecRecorder {
 public:
  using RecRecorder::RecRecorder;

 protected:
  std::string content(const std::string& recording) const override;
};

/// The same of a recording that was read.
std::string trace_of(const Recording& recording);

}  // namespace robosim::record
