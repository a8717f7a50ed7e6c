// What `robosim test` prints at the end.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/check/check_result.h"

namespace robosim::cli {

/// For one sketch: a line for each check, below a failure why and the command that replays it.
std::string sketch_report(const SketchResult& sketch);

/// For several: a line for each.
std::string class_report(const std::vector<SketchResult>& sketches);

}  // namespace robosim::cli
