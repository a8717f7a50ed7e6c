#include "sim/campaign/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/error.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/fleet.h"

namespace robosim::campaign {
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

}  // namespace

std::optional<analysis::Demand> demand_of(const SweepOptions& options) {
  if (!options.min_rate) return std::nullopt;
  return analysis::Demand{*options.min_rate, options.sure};
}

analysis::Tally count_runs_of(std::size_t combination, const SweepOptions& options, const SweepPlan& plan,
                              const std::vector<SweepOutcome>& outcomes,
                              const std::function<void(std::size_t run)>& visit) {
  analysis::Tally tally(static_cast<std::int64_t>(plan.seeds), demand_of(options));
  for (std::size_t i = 0; i < plan.seeds; ++i) {
    const std::size_t run = combination * plan.seeds + i;
    if (options.stop_early && tally.decided()) break;
    if (!outcomes[run].made()) continue;
    tally.add(outcomes[run].reached());
    if (visit) visit(run);
  }
  return tally;
}

std::vector<analysis::Tally> count_runs(const SweepOptions& options, const SweepPlan& plan,
                                        const std::vector<SweepOutcome>& outcomes) {
  std::vector<analysis::Tally> tallies;
  for (std::size_t i = 0; i < plan.combinations.size(); ++i)
    tallies.push_back(count_runs_of(i, options, plan, outcomes));
  return tallies;
}

Sweep::Sweep(const SweepOptions& options, const SweepPlan& plan, Progress& progress, Made made)
    : options_(options),
      plan_(plan),
      progress_(progress),
      on_made_(std::move(made)),
      outcomes_(plan.runs()),
      runs_(options.shard.share_of(plan.runs())) {
  const std::vector<SweepRow> merged = merged_rows(options.merge, plan);
  if (!options.csv.empty()) table_.emplace(options.csv, options.resume, plan, outcomes_);
  if (!merged.empty()) table_->take(merged, outcomes_);
  const auto demand = options.stop_early ? demand_of(options) : std::nullopt;
  counters_.assign(plan.combinations.size(), {static_cast<std::int64_t>(plan.seeds), demand});
  made_ = static_cast<std::size_t>(
      std::count_if(outcomes_.begin(), outcomes_.end(), [](const SweepOutcome& o) { return o.made(); }));
  count();
}

client::Batch Sweep::batch() {
  return {plan_.runs(), [this](std::size_t run) { return plan_.task_of(run); },
          [this](std::size_t run, client::Answer&& answer) { answered(run, std::move(answer)); },
          [this](std::size_t run) { return wanted(run); }};
}

bool Sweep::make_runs() {
  progress_.say(made_ > 0 ? fmt::format("{} of {} runs are finished already …", made_, runs_)
                          : fmt::format("{} runs …", runs_));
  const bool complete = client::make_runs(batch(), std::min(options_.jobs, runs_));
  progress_.clear();
  if (table_ && complete) table_->finish();
  return complete;
}

bool Sweep::wanted(std::size_t run) const {
  return options_.shard.has(run) && !outcomes_[run].made() && !counters_[run / plan_.seeds].decided();
}

/// Counts the outcomes, including the outcomes in the resumed table, in the order of the runs.
void Sweep::count() {
  for (; counted_ < plan_.runs(); ++counted_) {
    analysis::Tally& counter = counters_[counted_ / plan_.seeds];
    if (counter.decided()) continue;
    if (!outcomes_[counted_].made()) return;
    counter.add(outcomes_[counted_].reached());
  }
}

void Sweep::answered(std::size_t run, client::Answer&& answer) {
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
  if (on_made_) on_made_(combination, result);
  outcomes_[run] = {result.verdict, result.time_s, result.why, result.metrics.score};
  count();
  ++made_;
  progress_.update(
      fmt::format("{} of {} runs, seed {}, {}", made_, runs_, plan_.seed_of(run), combination.text()));
}

}  // namespace robosim::campaign
