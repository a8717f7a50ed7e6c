#include "sim/cli/sweep/sweep_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "sim/base/error.h"
#include "sim/campaign/sweep/sweep.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/cli/sweep/sweep_report.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/run_json.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {

int sweep_command(const SweepArguments& arguments) {
  terminal::Progress progress(true);
  const campaign::SweepPlan plan = campaign::SweepPlanner(listener_of(progress)).plan(arguments);
  for (const std::string& sentence : plan.left_out) complain(fmt::format("robosim: {}\n", sentence));
  campaign::Sweep::Made made;
  if (arguments.json)
    made = [](const campaign::Combination& combination, const result::RunResult& result) {
      print(launch::run_json_line(combination.inputs, result));
    };
  campaign::Sweep sweep(arguments, plan, progress, made);
  const bool complete = sweep.make_runs();

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
  if (!plan.left_out.empty()) return static_cast<int>(ExitStatus::bad_input);
  const auto tallies = campaign::count_runs(arguments, plan, sweep.outcomes());
  const bool met =
      std::all_of(tallies.begin(), tallies.end(), [](const analysis::Tally& t) { return t.met(); });
  return static_cast<int>(!arguments.min_rate || met ? ExitStatus::ok : ExitStatus::failed);
}

}  // namespace robosim::cli
