#include "sim/cli/mutate/trial.h"

#include <algorithm>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/cli/check/check_session.h"
#include "sim/client/interrupts.h"
#include "sim/client/pool.h"
#include "sim/tui/progress.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

Trial::Ending ending_of(const CheckResult& failed) {
  if (failed.status == ExitStatus::timeout) return Trial::Ending::late;
  return failed.only && failed.only->verdict == "hung" ? Trial::Ending::late : Trial::Ending::failed;
}

}  // namespace

Workbench::Workbench(const fs::path& folder, const fs::path& path, std::string checks, std::size_t jobs)
    : work_(build::Cache(build::cache_folder())), checks_(std::move(checks)), jobs_(jobs) {
  const fs::path from = fs::canonical(folder);
  copy_ = work_.path() / from.filename();
  fs::copy(from, copy_, fs::copy_options::recursive);
  const fs::path within = fs::canonical(path).lexically_relative(from);
  sketch_ = within == "." ? copy_.string() : (copy_ / within).string();
}

Trial Workbench::make_runs() {
  tui::Progress silent(false);
  SweepPlanner planner(silent, {false, false});
  CheckSession session(planner);
  session.add(sketch_, checks_);
  if (session.runs() > 0) {
    client::Pool pool(std::min(jobs_, session.runs()));
    const client::Interrupts interrupts(pool);
    if (!pool.run(session.batch())) return {Trial::Ending::interrupted, {}, "", "interrupted"};
  }
  const SketchResult result = session.results().front();
  Trial trial;
  if (result.problem) return {Trial::Ending::not_compiled, {}, "", result.problem->line};
  for (const CheckResult& check : result.results) {
    trial.traces.insert(trial.traces.end(), check.traces.begin(), check.traces.end());
    if (check.ok() || !trial.check.empty()) continue;
    trial.ending = ending_of(check);
    trial.check = check.name;
    trial.why = check.why;
  }
  return trial;
}

Trial Workbench::try_with(const mutate::Mutation& mutation) {
  const fs::path file = copy_ / mutation.edits.front().file;
  const std::string whole = read_file(file);
  write_file(file, mutate::changed(whole, mutation.edits));
  Trial trial = make_runs();
  write_file(file, whole);
  return trial;
}

}  // namespace robosim::cli
