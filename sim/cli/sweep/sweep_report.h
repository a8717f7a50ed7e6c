// The final output of a sweep.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/sweep/sweep.h"

namespace robosim::cli {

/// Returns a table with a line for each combination, the failures, and commands that repeat the first
/// failures. Also reports whether --min-rate is met. The report depends only on the outcomes.
std::string sweep_report(const campaign::SweepOptions& options, const campaign::SweepPlan& plan,
                         const std::vector<campaign::SweepOutcome>& outcomes);

}  // namespace robosim::cli
