// Plans the checks of sketches, and collects the results of their runs.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/progress.h"
#include "sim/campaign/analysis/success_rate.h"
#include "sim/campaign/check/check_result.h"
#include "sim/campaign/sweep/sweep_plan.h"
#include "sim/launch/client/pool.h"

namespace robosim::campaign {

class CheckSession {
 public:
  /// All sketches may use the Arduino libraries in the folders `libraries`. If `untrusted` is true, the
  /// sketches come from strangers. Such sketches run only on chips. Checks in a sketch's folder may name only
  /// files in that folder.
  explicit CheckSession(SweepPlanner& planner, std::vector<std::string> libraries = {},
                        bool untrusted = false)
      : planner_(planner), libraries_(std::move(libraries)), untrusted_(untrusted) {}

  /// Compiles the sketch and reads its checks from `file`, or from its checks.toml if `file` is empty. An
  /// error in a sketch or a file becomes the sketch's result.
  void add(const std::string& sketch, const std::string& file);

  /// Makes all runs of all checks, at most `jobs` at a time. Returns false if the user interrupted them.
  bool make_runs(std::size_t jobs, Progress& progress);

  /// Returns the results. A check with missing runs counts as interrupted.
  std::vector<SketchResult> results();

 private:
  /// A check whose runs are planned.
  struct Planned {
    std::size_t sketch;
    std::size_t result;  ///< index of the check in the sketch's results
    Check check;
    SweepPlan plan;
    std::vector<analysis::Tally> tallies;
    bool late_only = true;      ///< all failed runs timed out
    std::string first_failure;  ///< why the first failed run failed
    std::string first_name;     ///< the name of that run, if the check has several runs: "seed 4"
  };
  struct Run {
    std::size_t planned;
    std::size_t number;
  };

  /// Plans the runs of a check. If `limited`, limits the total simulated time of this check and of the
  /// sketch's earlier checks.
  void plan(const Check& check, bool limited);
  client::Batch batch(Progress& progress);
  void answered(const Run& run, const client::Answer& answer);
  void judge(Planned& planned, std::size_t run, const result::RunResult& result);
  void finish(Planned& planned);
  CheckResult& result_of(const Planned& planned) { return sketches_[planned.sketch].results[planned.result]; }

  SweepPlanner& planner_;
  std::vector<std::string> libraries_;
  bool untrusted_;
  std::vector<SketchResult> sketches_;
  std::deque<Planned> planned_;
  std::vector<Run> runs_;
  std::size_t ended_ = 0;
};

}  // namespace robosim::campaign
