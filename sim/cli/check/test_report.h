// The final output of `robosim test`.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/check/check_result.h"

namespace robosim::cli {

/// Returns the report on one sketch: a line for each check. A failure is followed by its reason and the
/// command that replays it.
std::string sketch_report(const campaign::SketchResult& sketch);

/// Returns the report on several sketches: one line for each sketch.
std::string class_report(const std::vector<campaign::SketchResult>& sketches);

}  // namespace robosim::cli
