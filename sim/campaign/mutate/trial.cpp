#include "sim/campaign/mutate/trial.h"

#include <stdlib.h>

#include <utility>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/campaign/check/check_session.h"
#include "sim/campaign/mutate/test_report.h"

namespace robosim::mutate {
namespace fs = std::filesystem;

namespace {

Trial::Ending ending_of(const campaign::CheckResult& failed) {
  if (failed.status == ExitStatus::timeout) return Trial::Ending::late;
  return failed.only && failed.only->verdict == "hung" ? Trial::Ending::late : Trial::Ending::failed;
}

Trial make_checks(const std::string& sketch, const std::string& file, std::size_t jobs) {
  campaign::SweepPlanner planner({});
  campaign::CheckSession session(planner);
  session.add(sketch, file);
  Progress silent;
  if (!session.make_runs(jobs, silent)) return {Trial::Ending::interrupted, {}, "", "interrupted"};
  const campaign::SketchResult result = session.results().front();
  Trial trial;
  if (result.problem) return {Trial::Ending::not_compiled, {}, "", result.problem->line};
  for (const campaign::CheckResult& check : result.results) {
    trial.traces.insert(trial.traces.end(), check.traces.begin(), check.traces.end());
    if (check.ok() || !trial.check.empty()) continue;
    trial.ending = ending_of(check);
    trial.check = check.name;
    trial.why = check.why;
  }
  return trial;
}

/// Runs the tests in the current folder. If that folder is in the sketch's folder, runs them in its copy.
Trial make_tests(const std::vector<std::string>& programs, const Workbench& bench) {
  const fs::path here = fs::current_path(), within = here.lexically_relative(bench.original());
  const bool is_outside = within.empty() || *within.begin() == "..";

  Trial trial;
  try {
    for (const std::string& program : programs) {
      const TestRun run = run_tests(program, "", is_outside ? here : bench.copy() / within, bench.scratch());
      for (const auto& [test, trace] : run.traces) trial.traces.push_back(test + ' ' + trace);
      if (run.failed.empty()) continue;
      trial.ending = Trial::Ending::failed;
      trial.check = run.failed;
      trial.why = run.message.substr(0, run.message.find('\n'));
      break;
    }
  } catch (const CouldNotRun& problem) {
    trial = {Trial::Ending::not_compiled, {}, "", problem.what()};
  } catch (const ProgramBroke& problem) {
    trial = {problem.late ? Trial::Ending::late : Trial::Ending::failed, {}, "", problem.what()};
  }
  return trial;
}

}  // namespace

Workbench::Workbench(const fs::path& folder, const fs::path& path)
    : work_(build::Cache(build::cache_folder())), original_(fs::canonical(folder)) {
  copy_ = work_.path() / original_.filename();
  fs::copy(original_, copy_, fs::copy_options::recursive);
  const fs::path within = fs::canonical(path).lexically_relative(original_);
  sketch_ = within == "." ? copy_.string() : (copy_ / within).string();
}

Trial Workbench::try_with(const Mutation& mutation, const Ask& ask) const {
  const fs::path file = copy_ / mutation.edits.front().file;
  const std::string whole = read_file(file);
  write_file(file, changed(whole, mutation.edits));
  Trial trial = ask(sketch_);
  write_file(file, whole);
  return trial;
}

Workbench::Ask ask_checks(std::string file, std::size_t jobs) {
  return
      [file = std::move(file), jobs](const std::string& sketch) { return make_checks(sketch, file, jobs); };
}

Workbench::Ask ask_tests(std::vector<std::string> programs, const Workbench& bench) {
  ::setenv("ROBOSIM_MUTANT", (bench.original().string() + "=" + bench.copy().string()).c_str(), 1);
  ::setenv("ROBOSIM_ARTIFACTS", "none", 1);
  return [programs = std::move(programs), &bench](const std::string&) { return make_tests(programs, bench); };
}

}  // namespace robosim::mutate
