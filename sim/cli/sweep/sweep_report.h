// The final output of a sweep.
#pragma once

#include <string>
#include <vector>

#include "sim/analysis/success_rate.h"
#include "sim/cli/arguments.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/cli/sweep/sweep_table.h"

namespace robosim::cli {

/// Counts the runs of each combination, in the order of their seeds; with `stop_early` up to the deciding
/// one. Missing runs are skipped.
std::vector<analysis::Tally> count_runs(const SweepArguments& arguments, const SweepPlan& plan,
                                        const std::vector<SweepOutcome>& outcomes);

/// Returns a table with a line for each combination, then the failures, with commands that repeat the first
/// ones. Then follows whether --min-rate holds. It depends on the outcomes alone.
std::string sweep_report(const SweepArguments& arguments, const SweepPlan& plan,
                         const std::vector<SweepOutcome>& outcomes);

}  // namespace robosim::cli
