#include "sim/cli/check/test_command.h"

#include <fmt/format.h>

#include <optional>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/campaign/check/check_session.h"
#include "sim/campaign/check/checks_file.h"
#include "sim/campaign/check/junit.h"
#include "sim/cli/check/github.h"
#include "sim/cli/check/test_report.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace {

/// Warns if a check for all sketches names no map or no robot. Files in the sketch's folder then determine
/// the map or robot, and the author of the sketch can choose these files.
void warn_of_own_files(const std::string& checks) try {
  for (const campaign::Check& check : campaign::read_checks(checks)) {
    if (!check.fleet.empty()) continue;
    std::string missing = check.sweep.maps.empty() ? "no map" : "";
    if (check.sweep.robots.empty()) missing += missing.empty() ? "no robot" : " and no robot";
    if (!missing.empty())
      complain(fmt::format(
          "robosim: {}: check \"{}\" has {}: files in a sketch's folder, written by the sketch's author, are "
          "used; name your own files in the check\n",
          checks, check.name, missing));
  }
} catch (const InputError&) {
  // Ignores the error, because the result of each sketch reports the same error.
}

}  // namespace

int test_command(const TestArguments& arguments) {
  std::optional<FileLock> claim;
  if (!arguments.junit.empty()) claim.emplace(arguments.junit);
  std::vector<std::string> sketches = arguments.sketches;
  if (sketches.empty()) sketches.emplace_back();
  const bool several = sketches.size() > 1;
  terminal::Progress progress(true);
  campaign::SweepPlanner planner(listener_of(progress, {false, !several}));
  campaign::CheckSession session(planner, arguments.libraries, arguments.untrusted);
  if (arguments.untrusted && arguments.checks.empty())
    complain(
        "robosim: each sketch is tested by the checks.toml in its own folder, which its author wrote; "
        "--checks "
        "FILE tests all sketches by a file of yours\n");
  if (arguments.untrusted && !arguments.checks.empty()) warn_of_own_files(arguments.checks);
  for (const std::string& sketch : sketches) session.add(sketch, arguments.checks);
  const bool complete = session.make_runs(arguments.jobs, progress);
  progress.clear();

  const std::vector<campaign::SketchResult> results = session.results();
  if (several) {
    print(class_report(results));
  } else {
    if (results[0].problem) complain(fmt::format("{}\n", results[0].problem->text));
    print(sketch_report(results[0]));
  }
  if (!arguments.junit.empty()) write_file(arguments.junit, campaign::junit_xml(results));
  if (on_github()) {
    print(github_notes(results));
    add_github_summary(results);
  }
  ExitStatus status = complete ? ExitStatus::ok : ExitStatus::interrupted;
  for (const campaign::SketchResult& result : results) status = campaign::worse(status, result.status());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
