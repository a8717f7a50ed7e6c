#include "sim/cli/check/test_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/cli/check/check_session.h"
#include "sim/cli/check/checks_file.h"
#include "sim/cli/check/github.h"
#include "sim/cli/check/junit.h"
#include "sim/cli/check/test_report.h"
#include "sim/cli/output.h"
#include "sim/launch/client/interrupts.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace {

/// Makes all runs. Returns false if the user interrupted them.
bool make_runs(CheckSession& session, std::size_t jobs, terminal::Progress& progress) {
  if (session.runs() == 0) return true;
  client::Pool pool(std::min(jobs, session.runs()));
  const client::Interrupts interrupts(pool);
  client::Batch batch = session.batch();
  batch.answered = [&, count = std::move(batch.answered)](std::size_t run, client::Answer answer) {
    count(run, std::move(answer));
    progress.update(fmt::format("{} of {} runs", session.runs_ended(), session.runs()));
  };
  return pool.run(batch);
}

/// Warns if a check for all sketches names no map or robot: a sketch's author may then choose it.
void warn_of_own_files(const std::string& checks) try {
  for (const Check& check : read_checks(checks)) {
    if (!check.fleet.empty()) continue;
    std::string missing = check.sweep.maps.empty() ? "no map" : "";
    if (check.sweep.robots.empty()) missing += missing.empty() ? "no robot" : " and no robot";
    if (!missing.empty())
      complain(fmt::format(
          "robosim: {}: check \"{}\" has {}: files in a sketch's folder are used, which its author "
          "wrote; name yours in the check\n",
          checks, check.name, missing));
  }
} catch (const InputError&) {
  // the result of each sketch contains the message
}

}  // namespace

int test_command(const TestArguments& arguments) {
  std::optional<FileLock> claim;
  if (!arguments.junit.empty()) claim.emplace(arguments.junit);
  std::vector<std::string> sketches = arguments.sketches;
  if (sketches.empty()) sketches.emplace_back();
  const bool several = sketches.size() > 1;
  terminal::Progress progress(true);
  SweepPlanner planner(progress, {false, !several});
  CheckSession session(planner, arguments.untrusted);
  if (arguments.untrusted && arguments.checks.empty())
    complain(
        "robosim: each sketch is tested by the checks.toml in its own folder, which its author wrote; "
        "--checks "
        "FILE tests all of them by one of yours\n");
  if (arguments.untrusted && !arguments.checks.empty()) warn_of_own_files(arguments.checks);
  for (const std::string& sketch : sketches) session.add(sketch, arguments.checks);
  const bool complete = make_runs(session, arguments.jobs, progress);
  progress.clear();

  const std::vector<SketchResult> results = session.results();
  if (several) {
    print(class_report(results));
  } else {
    if (results[0].problem) complain(fmt::format("{}\n", results[0].problem->text));
    print(sketch_report(results[0]));
  }
  if (!arguments.junit.empty()) write_file(arguments.junit, junit_xml(results));
  if (on_github()) {
    print(github_notes(results));
    add_github_summary(results);
  }
  ExitStatus status = complete ? ExitStatus::ok : ExitStatus::interrupted;
  for (const SketchResult& result : results) status = worse(status, result.status());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
