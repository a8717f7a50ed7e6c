// The final output of a sweep.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/analysis/success_rate.h"
#include "sim/cli/arguments.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/cli/sweep/sweep_table.h"

namespace robosim::cli {

/// Counts the runs of each combination, in the order of their seeds; with `stop_early` only up to the
/// deciding run. Skips missing runs.
std::vector<analysis::Tally> count_runs(const SweepArguments& arguments, const SweepPlan& plan,
                                        const std::vector<SweepOutcome>& outcomes);

/// Returns a table with a line for each combination, the failures, and commands that repeat the first ones.
/// Also reports whether --min-rate is met. The report depends only on the outcomes.
std::string sweep_report(const SweepArguments& arguments, const SweepPlan& plan,
                         const std::vector<SweepOutcome>& outcomes);

}  // namespace robosim::cli
