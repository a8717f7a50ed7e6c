#include "robosim/testing/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/testing/artifacts.h"
#include "sim/testing/reports.h"
#include "sim/testing/silent_run.h"
#include "sim/testing/simulation_impl.h"

namespace robosim::testing {
namespace fs = std::filesystem;

struct Fleet::Impl {
  FleetTrial trial;
  ResolvedFleetTrial all;
  std::shared_ptr<SharedRun> run;
  std::vector<ResolvedTrial> resolved_trials;
  std::vector<std::shared_ptr<RunLog>> logs;
  std::string artifacts, replay;

  /// Saves the artifacts that explain a failure.
  void keep() const;
};

Fleet::Fleet(FleetTrial trial) : impl_(std::make_unique<Impl>()) {
  report_to_github();
  impl_->trial = std::move(trial);
  try {
    impl_->all = resolve_fleet_trial(impl_->trial);
    scratch_ = impl_->all.scratch;
    impl_->run = std::make_shared<SharedRun>(impl_->all.chosen.runner);
    impl_->run->of_fleet = true;
    impl_->resolved_trials = resolve_trials(impl_->trial, impl_->all, *impl_->run->runner);
    impl_->artifacts = artifact_folder();
    impl_->replay = robosim::testing::replay_command(impl_->trial, impl_->artifacts);
    for (std::size_t i = 0; i < impl_->resolved_trials.size(); ++i) {
      names_.push_back(impl_->all.fleet.members[i].name);
      Trial alone = impl_->all.trials[i];
      auto inside = std::make_unique<Simulation::Impl>(alone, impl_->run, impl_->resolved_trials[i]);
      inside->log->name = names_.back();
      inside->log->artifacts = impl_->artifacts;
      inside->log->replay = impl_->replay;
      impl_->logs.push_back(inside->log);
      robots_.push_back(std::unique_ptr<Simulation>(new Simulation(std::move(alone), std::move(inside))));
    }
    impl_->run->begin(impl_->resolved_trials.front().request);
  } catch (...) {
    std::error_code ignored;
    if (!impl_->all.scratch.empty()) fs::remove_all(impl_->all.scratch, ignored);
    throw;
  }
}

Simulation& Fleet::robot(const std::string& name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    throw InputError(fmt::format("unknown robot: {}", expected_one_of(name, names_)));
  return *robots_[static_cast<std::size_t>(found - names_.begin())];
}

void Fleet::run_for(Duration time, const char* file, int line) { robots_.front()->run_for(time, file, line); }

void Fleet::run_to_the_end(const char* file, int line) {
  while (!over()) impl_->run->go_on(std::numeric_limits<std::int64_t>::max(), {}, {file, line});
}

Duration Fleet::now() const { return Duration(impl_->run->now_ns); }

bool Fleet::over() const { return impl_->run->over(); }

std::vector<std::string> Fleet::verdicts() const {
  std::vector<std::string> all;
  for (const auto& robot : robots_) all.push_back(robot->verdict());
  return all;
}

::testing::AssertionResult Fleet::all_reached() const {
  std::string others;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Drive drive = robots_[i]->so_far();
    if (const std::string verdict = robots_[i]->verdict(); verdict.empty())
      others += fmt::format("\n  {} drives on: {}", names_[i], place_of(robots_[i]->pose()));
    else if (verdict != "reached")
      others += fmt::format("\n  {} ended as {}: {}", names_[i], verdict, drive.why());
  }
  if (others.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << fmt::format("not all robots have reached their goals at {}:{}\n  replay: {}", seconds(now()),
                        others, replay_command());
}

std::string Fleet::replay_command() const {
  return fmt::format("{} --for {}ms", impl_->replay, impl_->run->now_ns / 1'000'000);
}

void Fleet::Impl::keep() const {
  const fs::path folder = artifacts;
  std::vector<std::string> scripts;
  for (std::size_t i = 0; i < resolved_trials.size(); ++i) scripts.push_back(run->run->script(i));
  keep_inputs(artifacts, all.fleet, resolved_trials, scripts);
  for (const auto& log : logs) keep_texts(*log, artifacts, log->name + "-");
  write_file(folder / "command.txt", fmt::format("{} --for {}ms\n", replay, run->now_ns / 1'000'000));
  record_kept(artifacts);
  if (run->now_ns == 0) return;
  const bool whole = run->over() && logs.front()->result && logs.front()->result->verdict != "interrupted";
  const std::string problem =
      record_again(all.fleet, resolved_trials, scripts, whole ? &run->result(0) : nullptr, run->now_ns,
                   artifacts, *run->runner);
  if (!problem.empty()) std::fputs(fmt::format("robosim: {}\n", problem).c_str(), stderr);
}

Fleet::~Fleet() {
  try {
    impl_->run->run->end();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const result::RunResult& result = impl_->run->result(i);
      robots_[i]->impl_->complain_unasked(result);
      robots_[i]->impl_->complain_detected(result);
      record_trace(result.trace_hash);
      if (i == 0 && !is_silent_run()) record_figures(*impl_->logs[i], result);
    }
    if (::testing::Test::HasFailure() && !impl_->artifacts.empty()) impl_->keep();
  } catch (const std::exception& problem) {
    impl_->run->runner.condemn();
    ADD_FAILURE() << problem.what();
  }
  std::error_code ignored;
  if (!scratch_.empty()) fs::remove_all(scratch_, ignored);
}

}  // namespace robosim::testing
