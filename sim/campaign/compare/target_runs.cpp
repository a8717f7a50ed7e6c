#include "sim/campaign/compare/target_runs.h"

#include <poll.h>

#include <optional>
#include <utility>

#include "sim/base/error.h"
#include "sim/launch/launch.h"

namespace robosim::campaign {
namespace {

void refuse_image(const launch::Launch& launch) {
  const launch::SketchChoice sketch =
      launch::choose_sketch(launch.sketch, launch.environment, launch.untrusted);
  if (!sketch.elf_target.empty())
    throw InputError({sketch.name, 0, 0},
                     "expected a sketch, which runs on all targets, got a compiled image for one");
}

TargetRun target_run_of_one(const CompareOptions& options, const std::string& target,
                            launch::Launcher& launcher) {
  launch::Launch launch = launch::launch_of(options.each);
  launch.target = target;
  if (target == "host") launch.request.clock_ns = 0;
  launch::Chosen chosen = choose(launch);
  client::Runner runner(target);
  launch::PreparedFleet run;
  run.members.push_back(launcher.prepare(
      launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
      runner.hello()));
  run.request = run.members.front().request;
  return {target, std::move(runner), {}, std::move(run)};
}

TargetRun target_run_of_fleet(const CompareOptions& options, const std::string& target,
                              launch::Launcher& launcher) {
  launch::Fleet fleet = options.each.fleet;
  for (launch::Member& member : fleet.members) {
    if (options.moves.empty() || options.moves == member.name) member.launch.target = target;
    if (member.launch.target.empty() || member.launch.target == "host") member.launch.request.clock_ns = 0;
  }
  launch::ChosenFleet chosen = choose(fleet);
  wire::RunRequest common = options.each.request;
  common.script.clear();
  client::Runner runner(chosen.runner);
  launch::PreparedFleet run = launch::prepare(
      launcher, fleet, std::move(chosen), common,
      [&](const std::string& name) { return runner.describe_robot(name); }, runner.hello());
  return {target, std::move(runner), std::move(fleet), std::move(run)};
}

}  // namespace

const std::string& TargetRun::name(std::size_t robot) const {
  return robot == 0 ? run.request.name : run.request.agents[robot - 1].name;
}

std::string& TargetRun::script(wire::RunRequest& request, std::size_t robot) {
  return robot == 0 ? request.script : request.agents[robot - 1].script;
}

std::vector<result::Lateness>& TargetRun::late(wire::RunRequest& request, std::size_t robot) {
  return robot == 0 ? request.late : request.agents[robot - 1].late;
}

launch::RunInputs TargetRun::inputs(std::size_t robot) const {
  return launch::inputs_of(run.members[robot], runner.hello().version);
}

std::vector<TargetRun> target_runs_of(const CompareOptions& options, const launch::Listener& listener) {
  const bool several = !options.each.fleet.members.empty();
  if (!several) refuse_image(options.each);
  for (const launch::Member& member : options.each.fleet.members) refuse_image(member.launch);
  launch::Launcher launcher(listener);
  std::vector<TargetRun> target_runs;
  for (const std::string& target : options.targets)
    target_runs.push_back((several ? target_run_of_fleet : target_run_of_one)(options, target, launcher));
  return target_runs;
}

TargetRun target_run_of(const CompareOptions& options, const std::string& target,
                        const launch::Listener& listener) {
  launch::Launcher launcher(listener);
  const bool several = !options.each.fleet.members.empty();
  return (several ? target_run_of_fleet : target_run_of_one)(options, target, launcher);
}

std::vector<Results> run_all(const std::vector<TargetRun*>& target_runs,
                             const std::vector<wire::RunRequest>& requests,
                             const std::vector<wire::OnEvent>& listeners) {
  std::vector<std::optional<result::RunResult>> results(target_runs.size());
  const auto take = [&](std::size_t i) {
    try {
      return target_runs[i]->runner.take(listeners[i]);
    } catch (const InputError& error) {
      throw launch::with_place(target_runs[i]->fleet, error);
    }
  };
  for (std::size_t i = 0; i < target_runs.size(); ++i) target_runs[i]->runner.begin(requests[i]);
  for (;;) {
    std::vector<pollfd> waiting;
    for (std::size_t i = 0; i < target_runs.size(); ++i)
      if (!results[i] && !(results[i] = take(i)))
        waiting.push_back({target_runs[i]->runner.descriptor(), POLLIN, 0});
    if (waiting.empty()) break;
    ::poll(waiting.data(), waiting.size(), -1);
  }
  std::vector<Results> all;
  for (auto& result : results) all.push_back(launch::results_of(std::move(*result)));
  return all;
}

}  // namespace robosim::campaign
