// What a sweep prints at the end.
#pragma once

#include <string>
#include <vector>

#include "sim/analysis/success_rate.h"
#include "sim/cli/arguments.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/cli/sweep/sweep_table.h"

namespace robosim::cli {

/// The runs of each combination, counted in the order of their seeds; with `stop_early` up to the one that
/// decided. Runs that were not made are passed over.
std::vector<analysis::Tally> count_runs(const SweepArguments& arguments, const SweepPlan& plan,
                                        const std::vector<SweepOutcome>& outcomes);

/// A table with a line for each combination; then what failed, with the commands that make the first of it
/// again; then whether --min-rate holds. It depends on the outcomes alone.
std::string sweep_report(const SweepArguments& arguments, const SweepPlan& plan,
                         const std::vector<SweepOutcome>& outcomes);

}  // namespace robosim::cli
