#include "sim/cli/sweep/sweep_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "sim/base/error.h"
#include "sim/campaign/analysis/success_rate.h"
#include "sim/cli/output.h"
#include "sim/cli/sweep/sweep_plan.h"
#include "sim/cli/sweep/sweep_report.h"
#include "sim/cli/sweep/sweep_table.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/pool.h"
#include "sim/launch/fleet.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace {

/// Returns the result of a run that Robosim failed to make, in the usual format.
result::RunResult error_result(const Combination& c, const wire::RunRequest& request,
                               const std::string& message) {
  result::RunResult result;
  result.verdict = kErrorVerdict;
  result.why = message;
  result.status = static_cast<int>(ExitStatus::internal);
  result.goal = request.goal;
  result.for_s = static_cast<double>(request.for_ns) * 1e-9;
  result.seed = request.seed;
  result.profile = to_string(profile_of(request.profile));
  result.image_sha256 = c.image_sha256;
  result.map_sha256 = c.map_sha256;
  result.robot_sha256 = c.robot_sha256;
  return result;
}

/// Throws if a file has changed during the sweep, because the table would mix results of two versions.
void check_unchanged(const Combination& c, const result::RunResult& result) {
  const auto check = [](const std::string& file, const std::string& then, const std::string& now) {
    if (then != now)
      throw InputError({file, 0, 0}, "was changed during the sweep; begin again, with another --csv file");
  };
  check(c.task.request.image, c.image_sha256, result.image_sha256);
  check(c.task.request.map, c.map_sha256, result.map_sha256);
  check(c.task.request.robot, c.robot_sha256, result.robot_sha256);
}

class Sweep {
 public:
  Sweep(const SweepArguments& arguments, const SweepPlan& plan, terminal::Progress& progress)
      : arguments_(arguments),
        plan_(plan),
        progress_(progress),
        outcomes_(plan.runs()),
        runs_(arguments.shard.share_of(plan.runs())) {
    const std::vector<SweepRow> merged = merged_rows(arguments.merge, plan);
    if (!arguments.csv.empty()) table_.emplace(arguments.csv, arguments.resume, plan, outcomes_);
    if (!merged.empty()) table_->take(merged, outcomes_);
    for (std::size_t i = 0; i < plan.combinations.size(); ++i) counters_.push_back(counter());
    made_ = static_cast<std::size_t>(
        std::count_if(outcomes_.begin(), outcomes_.end(), [](const SweepOutcome& o) { return o.made(); }));
    count();
  }

  client::Batch batch() {
    return {plan_.runs(), [this](std::size_t run) { return plan_.task_of(run); },
            [this](std::size_t run, client::Answer&& answer) { answered(run, std::move(answer)); },
            [this](std::size_t run) { return wanted(run); }};
  }

  void finish(bool complete) {
    if (table_ && complete) table_->finish();
  }

  const std::vector<SweepOutcome>& outcomes() const { return outcomes_; }
  bool failed_itself() const { return failed_itself_; }
  std::size_t made() const { return made_; }
  /// Returns the number of runs in this shard.
  std::size_t runs() const { return runs_; }

 private:
  analysis::Tally counter() const {
    std::optional<analysis::Demand> demand;
    if (arguments_.stop_early) demand = analysis::Demand{*arguments_.min_rate, arguments_.sure};
    return {static_cast<std::int64_t>(plan_.seeds), demand};
  }

  bool wanted(std::size_t run) const {
    return arguments_.shard.has(run) && !outcomes_[run].made() && !counters_[run / plan_.seeds].decided();
  }

  /// Counts the outcomes in the order of the runs, including those of the resumed table.
  void count() {
    for (; counted_ < plan_.runs(); ++counted_) {
      analysis::Tally& counter = counters_[counted_ / plan_.seeds];
      if (counter.decided()) continue;
      if (!outcomes_[counted_].made()) return;
      counter.add(outcomes_[counted_].reached());
    }
  }

  void answered(std::size_t run, client::Answer&& answer) {
    const Combination& combination = plan_.combination_of(run);
    if (const auto* failure = std::get_if<client::Failure>(&answer)) {
      if (failure->kind == client::Failure::Kind::input) throw InputError(failure->message);
      if (failure->kind == client::Failure::Kind::tool) throw ToolMissing(failure->message);
      failed_itself_ = true;
      answer = error_result(combination, plan_.task_of(run).request, failure->message);
    }
    const result::RunResult result =
        launch::whole_of(std::get<result::RunResult>(answer), combination.task.request);
    check_unchanged(combination, result);
    if (table_) table_->add(run, sweep_row(combination, result, table_->columns()));
    if (arguments_.json) print(run_json_line(combination.inputs, result));
    outcomes_[run] = {result.verdict, result.time_s, result.why, result.metrics.score};
    count();
    ++made_;
    progress_.update(
        fmt::format("{} of {} runs, seed {}, {}", made_, runs_, plan_.seed_of(run), combination.text()));
  }

  const SweepArguments& arguments_;
  const SweepPlan& plan_;
  terminal::Progress& progress_;
  std::vector<SweepOutcome> outcomes_;
  std::optional<SweepTable> table_;
  std::vector<analysis::Tally> counters_;  ///< have a demand only if runs may be skipped
  std::size_t counted_ = 0;
  std::size_t made_ = 0;
  std::size_t runs_;  ///< of the shard
  bool failed_itself_ = false;
};

}  // namespace

int sweep_command(const SweepArguments& arguments) {
  terminal::Progress progress(true);
  const SweepPlan plan = SweepPlanner(progress, {}).plan(arguments);
  Sweep sweep(arguments, plan, progress);
  bool complete = false;
  {
    client::Pool pool(std::clamp<std::size_t>(arguments.jobs, 1, std::max<std::size_t>(1, sweep.runs())));
    const client::Interrupts interrupts(pool);
    progress.say(sweep.made() > 0
                     ? fmt::format("{} of {} runs are finished already …", sweep.made(), sweep.runs())
                     : fmt::format("{} runs …", sweep.runs()));
    complete = pool.run(sweep.batch());
  }
  progress.clear();
  sweep.finish(complete);

  const std::string report = sweep_report(arguments, plan, sweep.outcomes());
  if (arguments.json) {
    complain(report);
  } else {
    print(report);
  }
  if (!complete) {
    complain(fmt::format("robosim: interrupted; {}\n", arguments.csv.empty()
                                                           ? "the table holds the finished runs"
                                                           : "the same command with --resume continues"));
    if (client::Interrupts::signal() == SIGTERM || client::Interrupts::signal() == SIGHUP)
      ::raise(client::Interrupts::signal());
    return static_cast<int>(ExitStatus::interrupted);
  }
  if (sweep.failed_itself()) return static_cast<int>(ExitStatus::internal);
  const auto tallies = count_runs(arguments, plan, sweep.outcomes());
  const bool met =
      std::all_of(tallies.begin(), tallies.end(), [](const analysis::Tally& t) { return t.met(); });
  return static_cast<int>(!arguments.min_rate || met ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
