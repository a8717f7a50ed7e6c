#include "sim/campaign/check/check_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "sim/base/robot_name.h"
#include "sim/base/system_error.h"
#include "sim/build/process.h"
#include "sim/build/project.h"
#include "sim/build/sketch.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/fleet.h"
#include "sim/launch/names.h"
#include "sim/launch/trust.h"
#include "sim/wire/protocol.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

/// Returns the place at the beginning of a compiler's message. The sketch's files are relative to its folder.
Place place_in(const std::string& line, const fs::path& folder) {
  const std::size_t colon = line.find(':');
  if (colon == std::string::npos) return {};
  const int number = std::atoi(line.c_str() + colon + 1);
  if (number <= 0) return {};
  const fs::path file = line.substr(0, colon);
  std::error_code error;
  return {(fs::exists(folder / file, error) ? folder / file : file).string(), number, 0};
}

void set_problem(SketchResult& result, const Place& place, const std::string& line, const std::string& text) {
  SketchResult::Problem& problem = result.problem.emplace();
  problem.place = place;
  problem.line = line;
  problem.text = text;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string where_text(const SweepPlan& plan) {
  std::vector<std::string> maps, robots, targets;
  for (const Combination& combination : plan.combinations) {
    add_once(maps, combination.inputs.map);
    add_once(robots, combination.inputs.robot);
    add_once(targets, combination.inputs.target);
  }
  std::string text = joined(maps) + " · " + joined(robots);
  if (targets != std::vector<std::string>{"host"}) text += " · " + joined(targets);
  if (plan.seeds > 1)
    text += fmt::format(" · seeds {}..{}", plan.first_seed, plan.first_seed + plan.seeds - 1);
  return text;
}

/// Describes a run by the values that differ between the runs of its check.
std::string run_text(const SweepPlan& plan, std::size_t run) {
  std::string text = plan.seeds > 1 ? fmt::format("seed {}", plan.seed_of(run)) : "";
  if (plan.combinations.size() == 1) return text;
  const launch::RunInputs& in = plan.combination_of(run).inputs;
  return fmt::format("{}{} with {}, target {}", text.empty() ? "" : text + " on ", in.map, in.robot,
                     in.target);
}

/// Sets the restrictions of an untrusted sketch for a check. Throws InputError if the check violates a
/// restriction. If `folder` is not empty, all files that the check names must be in `folder`.
void confine(Check& check, const fs::path& folder) {
  SweepOptions& sweep = check.sweep;
  sweep.each.untrusted = sweep.each.chip_only = true;
  for (const std::string& target : sweep.targets)
    if (target == "host")
      throw InputError(
          check.place,
          "target: with --untrusted, expected avr, stm32, or no target (the chip of the robot's board), "
          "got host; on the host, the sketch would share its judge's memory");
  if (folder.empty()) return;
  std::vector<std::string> files = sweep.each.libraries;
  if (!sweep.each.script.empty()) files.push_back(sweep.each.script);
  for (const auto* names : {&sweep.maps, &sweep.robots})
    for (const std::string& name : *names)
      if (launch::is_path(parse_robot_name(name).robot)) files.push_back(parse_robot_name(name).robot);
  std::error_code error;
  for (const std::string& file : files)
    if (fs::exists(file, error) && !build::lies_in(file, folder))
      throw InputError(check.place,
                       fmt::format("{} is outside the sketch's folder; with --untrusted only the checks of "
                                   "--checks may name such files",
                                   file));
}

/// Returns the sum of the maximum simulated times of all runs of a plan, in seconds.
double simulated_s(const SweepPlan& plan) {
  double sum_s = 0.0;
  for (const Combination& combination : plan.combinations)
    sum_s += 1e-9 * static_cast<double>(plan.seeds) * static_cast<double>(combination.task.request.for_ns);
  return sum_s;
}

/// Maximum total simulated time of the checks in an untrusted sketch's folder. Emulating an Uno for this
/// simulated time takes 100 s of wall time.
constexpr double kMostSimulated_s = 3600.0;

analysis::Demand demand_in(const Check& check) {
  return {check.sweep.min_rate.value_or(1.0), check.sweep.sure};
}

}  // namespace

void CheckSession::add(const std::string& sketch, const std::string& file) {
  SketchResult& result = sketches_.emplace_back();
  result.name = sketch.empty() ? fs::current_path().filename().string() : launch::title_of(sketch, sketch);
  const std::size_t runs_before = runs_.size();
  fs::path folder;
  try {
    const launch::SketchChoice choice = launch::choose_sketch(sketch, {}, untrusted_);
    folder = choice.folder;
    if (untrusted_) launch::check_folder(choice);
    if (choice.elf_target.empty())
      build::read_sketch(choice.path, {choice.project.sources, choice.project.includes, {}});
    const fs::path beside =
        choice.folder == fs::current_path() ? "checks.toml" : choice.folder / "checks.toml";
    result.checks = file.empty() ? beside.string() : file;
    std::error_code error;
    if (!fs::exists(result.checks, error)) {
      throw InputError({result.checks, 0, 0},
                       "no such file; “robosim new” creates a project with a checks.toml, and --checks FILE "
                       "uses one file for all sketches");
    }
    for (Check check : read_checks(result.checks)) {
      if (!check.fleet.empty())
        check.sweep.sketches = {check.fleet};
      else if (!sketch.empty())
        check.sweep.sketches = {sketch};
      if (untrusted_) confine(check, file.empty() ? choice.folder : "");
      std::vector<std::string>& libraries = check.sweep.each.libraries;
      libraries.insert(libraries.begin(), libraries_.begin(), libraries_.end());
      CheckResult& planned = result.results.emplace_back();
      planned.name = check.name;
      planned.place = check.place;
      plan(check, untrusted_ && file.empty());
    }
  } catch (const build::CompileError& error) {
    const std::string line = error.first_line();
    set_problem(result, place_in(line, folder), line, error.what());
  } catch (const InputError& error) {
    set_problem(result, error.place(), error.what(), fmt::format("robosim: {}", error.what()));
  } catch (const fs::filesystem_error& error) {
    set_problem(result, {}, error.what(), fmt::format("robosim: {}", error.what()));
  }
  if (!result.problem) return;
  runs_.resize(runs_before);
  std::erase_if(planned_, [&](const Planned& planned) { return planned.sketch == sketches_.size() - 1; });
}

void CheckSession::plan(const Check& check, bool limited) {
  SketchResult& sketch = sketches_.back();
  CheckResult& result = sketch.results.back();
  try {
    Planned planned{
        sketches_.size() - 1, sketch.results.size() - 1, check, planner_.plan(check.sweep), {}, true, {}, {}};
    double sum_s = simulated_s(planned.plan);
    for (const Planned& earlier : planned_)
      if (earlier.sketch == planned.sketch) sum_s += simulated_s(earlier.plan);
    if (limited && sum_s > kMostSimulated_s)
      throw InputError(
          check.place,
          fmt::format("with --untrusted, all runs of a sketch's own checks together: expected at most "
                      "{:.0f} s of simulated time, got {:.0f} s up to this check; lower “seeds” or "
                      "“for”, or use --checks",
                      kMostSimulated_s, sum_s));
    for (Combination& combination : planned.plan.combinations) combination.task.request.detect = check.detect;
    result.where = where_text(planned.plan);
    const auto seeds = static_cast<std::int64_t>(planned.plan.seeds);
    planned.tallies.assign(planned.plan.combinations.size(), analysis::Tally(seeds, demand_in(check)));
    for (std::size_t run = 0; run < planned.plan.runs(); ++run) runs_.push_back({planned_.size(), run});
    planned_.push_back(std::move(planned));
  } catch (const build::CompileError&) {
    throw;
  } catch (const InputError& error) {
    result.status = ExitStatus::bad_input;
    const bool placed = !error.place().file.empty();
    result.why = InputError(placed ? error.place() : check.place, error.message()).what();
  } catch (const ToolMissing& error) {
    result.status = ExitStatus::tool_missing;
    result.why = error.what();
  } catch (const build::Interrupted&) {
    throw;
  } catch (const std::exception& error) {  // other sketches keep their results
    const std::string fault = system_error_of(error);
    result.status = fault.empty() ? ExitStatus::internal : ExitStatus::tool_missing;
    result.why = fault.empty() ? fmt::format("internal error: {}", error.what()) : fault;
  }
}

client::Batch CheckSession::batch(Progress& progress) {
  return {runs_.size(),
          [this](std::size_t i) { return planned_[runs_[i].planned].plan.task_of(runs_[i].number); },
          [this, &progress](std::size_t i, const client::Answer& answer) {
            answered(runs_[i], answer);
            progress.update(fmt::format("{} of {} runs", ended_, runs_.size()));
          },
          [this](std::size_t i) {
            Planned& planned = planned_[runs_[i].planned];
            if (result_of(planned).status != ExitStatus::interrupted) return false;  // after an error
            return !planned.check.sweep.stop_early ||
                   !planned.tallies[runs_[i].number / planned.plan.seeds].decided();
          }};
}

bool CheckSession::make_runs(std::size_t jobs, Progress& progress) {
  return runs_.empty() || client::make_runs(batch(progress), jobs);
}

void CheckSession::answered(const Run& run, const client::Answer& answer) {
  ++ended_;
  Planned& planned = planned_[run.planned];
  if (const auto* failure = std::get_if<client::Failure>(&answer)) {
    CheckResult& result = result_of(planned);
    result.status = failure->kind == client::Failure::Kind::input  ? ExitStatus::bad_input
                    : failure->kind == client::Failure::Kind::tool ? ExitStatus::tool_missing
                                                                   : ExitStatus::internal;
    result.why = failure->message;
    return;
  }
  judge(planned, run.number,
        launch::whole_of(std::get<result::RunResult>(answer),
                         planned.plan.combination_of(run.number).task.request));
}

void CheckSession::judge(Planned& planned, std::size_t run, const result::RunResult& run_result) {
  CheckResult& result = result_of(planned);
  const auto why = why_failed(planned.check, run_result);
  planned.tallies[run / planned.plan.seeds].add(!why);
  ++result.runs;
  result.traces.resize(planned.plan.runs());
  result.traces[run] = run_result.trace_hash;
  result.time_s += run_result.time_s;
  if (planned.plan.runs() == 1) result.only = run_result;
  if (!why) {
    ++result.passed;
    for (const double lap_s : run_result.metrics.laps_s)
      result.best_lap_s = std::min(lap_s, result.best_lap_s.value_or(lap_s));
    return;
  }
  if (run_result.verdict != "timeout") planned.late_only = false;
  if (!planned.first_failure.empty()) return;
  planned.first_failure = *why;
  planned.first_name = run_text(planned.plan, run);
  result.serial = run_result.serial;
  result.again = replay_command(planned.plan.combination_of(run), planned.plan.seed_of(run));
  result.again_trace_hash = run_result.trace_hash;
  result.replay = result.again;
  if (is_of_detectors(*why)) result.replay += " --sanitize";  // `run` may need this option to use detectors
}

void CheckSession::finish(Planned& planned) {
  CheckResult& result = result_of(planned);
  if (result.status != ExitStatus::interrupted) return;
  const auto& tallies = planned.tallies;
  if (std::all_of(tallies.begin(), tallies.end(), [](const analysis::Tally& t) { return t.met(); })) {
    result.status = ExitStatus::ok;
    return;
  }
  if (!std::all_of(tallies.begin(), tallies.end(), [](const analysis::Tally& t) { return t.decided(); })) {
    result.why = "interrupted";
    return;
  }
  result.status = planned.late_only ? ExitStatus::timeout : ExitStatus::failed;
  result.why = planned.first_failure;
  if (planned.plan.runs() == 1) return;
  std::string needed;
  if (planned.check.sweep.min_rate) {
    needed = fmt::format("; min-rate = {}{} needs {} of {}", *planned.check.sweep.min_rate,
                         planned.check.sweep.sure ? ", sure," : "",
                         *analysis::needed_successes(demand_in(planned.check), tallies[0].planned()),
                         tallies[0].planned());
  }
  result.why = fmt::format("{} of {} runs failed{}; {}: {}", result.runs - result.passed, result.runs, needed,
                           planned.first_name, planned.first_failure);
}

std::vector<SketchResult> CheckSession::results() {
  for (Planned& planned : planned_) finish(planned);
  return sketches_;
}

}  // namespace robosim::campaign
