// Plans the checks of sketches, and collects the results of their runs.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "sim/analysis/success_rate.h"
#include "sim/cli/check/check_result.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/client/pool.h"

namespace robosim::cli {

class CheckSession {
 public:
  /// `untrusted`: the sketches are a stranger's. They run on chips. Their own checks are a stranger's, too,
  /// and name no file outside of the sketch's folder.
  explicit CheckSession(SweepPlanner& planner, bool untrusted = false)
      : planner_(planner), untrusted_(untrusted) {}

  /// Reads the sketch's checks (`file`, or its checks.toml if that is empty) and compiles. An error in a
  /// sketch or a file becomes its result.
  void add(const std::string& sketch, const std::string& file);

  /// Returns all runs of all checks. They are counted as they are handed out.
  client::Batch batch();
  std::size_t runs() const { return runs_.size(); }
  std::size_t runs_ended() const { return ended_; }

  /// Returns the results; checks with a missing run were interrupted.
  std::vector<SketchResult> results();

 private:
  /// A check whose runs are planned.
  struct Planned {
    std::size_t sketch;
    std::size_t result;  ///< its index in the sketch's results
    Check check;
    SweepPlan plan;
    std::vector<analysis::Tally> tallies;
    bool late_only = true;      ///< all failed runs timed out
    std::string first_failure;  ///< the reason
    std::string first_name;     ///< the name of that run, if there are several: "seed 4"
  };
  struct Run {
    std::size_t planned;
    std::size_t number;
  };

  /// `limited`: its runs, and those of the sketch's earlier checks, must not take too long.
  void plan(const Check& check, bool limited);
  void answered(const Run& run, const client::Answer& answer);
  void judge(Planned& planned, std::size_t run, const wire::RunResult& result);
  void finish(Planned& planned);
  CheckResult& result_of(const Planned& planned) { return sketches_[planned.sketch].results[planned.result]; }

  SweepPlanner& planner_;
  bool untrusted_;
  std::vector<SketchResult> sketches_;
  std::deque<Planned> planned_;
  std::vector<Run> runs_;
  std::size_t ended_ = 0;
};

}  // namespace robosim::cli
