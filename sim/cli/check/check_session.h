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
  /// `untrusted`: the sketches are somebody else's. They run on chips; and checks beside them, which are
  /// somebody else's, too, name no file outside of the sketch's folder.
  explicit CheckSession(SweepPlanner& planner, bool untrusted = false)
      : planner_(planner), untrusted_(untrusted) {}

  /// Reads the sketch's checks (`file`, or those beside it if that is empty) and compiles. What is wrong with
  /// a sketch or a file becomes its result.
  void add(const std::string& sketch, const std::string& file);

  /// All runs of all checks. They are counted as they are handed over.
  client::Batch batch();
  std::size_t runs() const { return runs_.size(); }
  std::size_t runs_ended() const { return ended_; }

  /// The results; checks with a run missing were interrupted.
  std::vector<SketchResult> results();

 private:
  /// A check whose runs are planned.
  struct Planned {
    std::size_t sketch;
    std::size_t result;  ///< its place among the sketch's
    Check check;
    SweepPlan plan;
    std::vector<analysis::Tally> tallies;
    bool late_only = true;      ///< no run failed but by time
    std::string first_failure;  ///< why
    std::string first_name;     ///< of that run, where there are several: "seed 4"
  };
  struct Run {
    std::size_t planned;
    std::size_t number;
  };

  void plan(const Check& check);
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
