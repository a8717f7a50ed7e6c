// Makes the runs of a sweep.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "sim/base/progress.h"
#include "sim/campaign/analysis/success_rate.h"
#include "sim/campaign/sweep/sweep_options.h"
#include "sim/campaign/sweep/sweep_plan.h"
#include "sim/campaign/sweep/sweep_table.h"
#include "sim/launch/client/pool.h"

namespace robosim::campaign {

/// Returns the demand that --min-rate and --sure state; nothing without --min-rate.
std::optional<analysis::Demand> demand_of(const SweepOptions& options);

/// Counts the runs of one combination, in the order of their seeds. With `stop_early`, counts only up to the
/// run that decides the demand. Skips missing runs. Calls `visit` with each counted run.
analysis::Tally count_runs_of(std::size_t combination, const SweepOptions& options, const SweepPlan& plan,
                              const std::vector<SweepOutcome>& outcomes,
                              const std::function<void(std::size_t run)>& visit = {});

/// Counts the runs of each combination.
std::vector<analysis::Tally> count_runs(const SweepOptions& options, const SweepPlan& plan,
                                        const std::vector<SweepOutcome>& outcomes);

class Sweep {
 public:
  /// Receives each finished run.
  using Made = std::function<void(const Combination& combination, const result::RunResult& result)>;

  /// Reads the tables of --resume and --merge. The arguments must outlive this object. Throws InputError.
  Sweep(const SweepOptions& options, const SweepPlan& plan, Progress& progress, Made made = {});

  /// Makes the missing runs and completes the table. Returns false if the user interrupted the runs. Throws
  /// InputError and ToolMissing.
  bool make_runs();

  const std::vector<SweepOutcome>& outcomes() const { return outcomes_; }
  /// Returns whether Robosim itself failed in a run.
  bool failed_itself() const { return failed_itself_; }

 private:
  client::Batch batch();
  bool wanted(std::size_t run) const;
  void count();
  void answered(std::size_t run, client::Answer&& answer);

  const SweepOptions& options_;
  const SweepPlan& plan_;
  Progress& progress_;
  Made on_made_;
  std::vector<SweepOutcome> outcomes_;
  std::optional<SweepTable> table_;
  std::vector<analysis::Tally> counters_;  ///< have a demand only if runs may be skipped
  std::size_t counted_ = 0;
  std::size_t made_ = 0;
  std::size_t runs_;  ///< number of runs of the shard
  bool failed_itself_ = false;
};

}  // namespace robosim::campaign
