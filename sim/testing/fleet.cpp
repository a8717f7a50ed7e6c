#include "robosim/testing/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/spelling.h"
#include "sim/testing/artifacts.h"
#include "sim/testing/inside.h"
#include "sim/testing/rehearsal.h"
#include "sim/testing/reports.h"

namespace robosim::testing {
namespace fs = std::filesystem;

struct Fleet::Inside {
  FleetTrial trial;
  FleetStage all;
  std::shared_ptr<SharedRun> run;
  std::vector<Stage> stages;
  std::vector<std::shared_ptr<RunLog>> logs;
  std::string artifacts, replay;

  /// Saves the artifacts that explain a failure.
  void keep() const;
};

Fleet::Fleet(FleetTrial trial) : in_(std::make_unique<Inside>()) {
  report_to_github();
  in_->trial = std::move(trial);
  try {
    in_->all = choose_stage(in_->trial);
    scratch_ = in_->all.scratch;
    in_->run = std::make_shared<SharedRun>(in_->all.chosen.runner);
    in_->run->of_fleet = true;
    in_->stages = set_stages(in_->trial, in_->all, *in_->run->runner);
    in_->artifacts = artifact_folder();
    in_->replay = robosim::testing::replay_command(in_->trial, in_->artifacts);
    for (std::size_t i = 0; i < in_->stages.size(); ++i) {
      names_.push_back(in_->all.fleet.members[i].name);
      Trial alone = in_->all.trials[i];
      auto inside = std::make_unique<Simulation::Inside>(alone, in_->run, in_->stages[i]);
      inside->log->name = names_.back();
      inside->log->artifacts = in_->artifacts;
      inside->log->replay = in_->replay;
      in_->logs.push_back(inside->log);
      robots_.push_back(std::unique_ptr<Simulation>(new Simulation(std::move(alone), std::move(inside))));
    }
    in_->run->begin(in_->stages.front().request);
  } catch (...) {
    std::error_code ignored;
    if (!in_->all.scratch.empty()) fs::remove_all(in_->all.scratch, ignored);
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
  while (!over()) in_->run->go_on(std::numeric_limits<std::int64_t>::max(), {}, {file, line});
}

Duration Fleet::now() const { return Duration(in_->run->now_ns); }

bool Fleet::over() const { return in_->run->over(); }

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
  return fmt::format("{} --for {}ms", in_->replay, in_->run->now_ns / 1'000'000);
}

void Fleet::Inside::keep() const {
  const fs::path folder = artifacts;
  std::vector<std::string> scripts;
  for (std::size_t i = 0; i < stages.size(); ++i) scripts.push_back(run->run->script(i));
  keep_inputs(artifacts, all.fleet, stages, scripts);
  for (const auto& log : logs) keep_texts(*log, artifacts, log->name + "-");
  write_file(folder / "command.txt", fmt::format("{} --for {}ms\n", replay, run->now_ns / 1'000'000));
  record_kept(artifacts);
  if (run->now_ns == 0) return;
  const bool whole = run->over() && logs.front()->result && logs.front()->result->verdict != "interrupted";
  const std::string problem = record_again(all.fleet, stages, scripts, whole ? &run->result(0) : nullptr,
                                           run->now_ns, artifacts, *run->runner);
  if (!problem.empty()) std::fputs(fmt::format("robosim: {}\n", problem).c_str(), stderr);
}

Fleet::~Fleet() {
  try {
    in_->run->run->end();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const wire::RunResult& result = in_->run->result(i);
      robots_[i]->in_->complain_unasked(result);
      robots_[i]->in_->complain_detected(result);
      record_trace(result.trace_hash);
      if (i == 0 && !is_rehearsal()) record_figures(*in_->logs[i], result);
    }
    if (::testing::Test::HasFailure() && !in_->artifacts.empty()) in_->keep();
  } catch (const std::exception& problem) {
    in_->run->runner.condemn();
    ADD_FAILURE() << problem.what();
  }
  std::error_code ignored;
  if (!scratch_.empty()) fs::remove_all(scratch_, ignored);
}

}  // namespace robosim::testing
