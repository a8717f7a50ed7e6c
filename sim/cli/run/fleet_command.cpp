#include "sim/cli/run/fleet_command.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/wall_clock.h"
#include "sim/campaign/rerun/recorded.h"
#include "sim/campaign/rerun/sanitizer_rerun.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/cli/run/end_screen.h"
#include "sim/cli/run/live.h"
#include "sim/cli/run/recorders.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/fleet.h"
#include "sim/launch/run_json.h"
#include "sim/record/recorder.h"
#include "sim/view/terminal/fleet_report.h"
#include "sim/view/terminal/live_view.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace {

/// Returns 0 if all robots have reached their goals; otherwise the most important failure.
int status_of(const std::vector<result::RunResult>& results) {
  // Checks the signals first, because the verdict `interrupted` is ambiguous. If a sketch has crashed the
  // process, the runs of the other robots are interrupted, too.
  if (client::Interrupts::count() > 0) return static_cast<int>(ExitStatus::interrupted);
  for (const ExitStatus status : {ExitStatus::failed, ExitStatus::timeout, ExitStatus::interrupted})
    for (const result::RunResult& result : results)
      if (result.status == static_cast<int>(status)) return result.status;
  return static_cast<int>(ExitStatus::ok);
}

/// Runs the robots in the live view.
result::RunResult watch(client::Runner& runner, const launch::PreparedFleet& run, const launch::Fleet& fleet,
                        const RunArguments& arguments, const wire::OnEvent& on_event) {
  runner.keep_close();
  const launch::Prepared& first = run.members.front();
  const map::Map floor = map_of(run.request);
  std::vector<std::string> names;
  for (const launch::Member& member : fleet.members) names.push_back(member.name);
  terminal::LiveScene scene(
      fmt::format("{} robots on {}; below: {}", names.size(), first.map.name, names.front()), floor,
      first.robot_info, names);
  terminal::LiveView live(scene,
                          {arguments.speed, terminal::look_from_environment(true),
                           [] { return client::Interrupts::count() > 0; }, [&] { runner.interrupt(); }});
  const result::RunResult result = runner.run(run.request, [&](const wire::Event& event) {
    on_event(event);
    live.on_event(event);
  });
  live.finish(launch::whole_of(result, run.request));
  return result;
}

}  // namespace

int fleet_command(const RunArguments& arguments) {
  record::Recorders recorders = recorders_of(arguments);
  const std::vector<FileLock> claims = claims_of(arguments);
  launch::Fleet fleet = arguments.fleet;
  launch::ChosenFleet chosen = choose(fleet);
  check_view(arguments);
  terminal::Progress progress(!arguments.view && !arguments.live);
  wire::RunRequest common = arguments.request;
  common.script.clear();
  const bool draws = !arguments.json && !arguments.live;
  common.samples_every_ns = draws || progress.active() ? terminal::trail_every_ns(common.for_ns) : 0;
  if (arguments.view) common.samples_every_ns = terminal::kViewEvery_ns;
  common.serial = arguments.view || arguments.live;
  if (arguments.live) common.columns_every_ns = record::kRecordEvery_ns;
  common.notes = true;
  common.batches = !arguments.view && !arguments.live;
  recorders.ask(common);

  client::Runner runner(chosen.runner);
  launch::Launcher launcher(listener_of(progress));
  const launch::PreparedFleet run = launch::prepare(
      launcher, fleet, std::move(chosen), common,
      [&](const std::string& name) { return runner.describe_robot(name); }, runner.hello());

  terminal::FleetReport report;
  report.map = run.members.front().map.name;
  for (std::size_t i = 0; i < run.members.size(); ++i) {
    const launch::Prepared& member = run.members[i];
    report.rows.push_back(
        {fleet.members[i].name, launch::title_of(member.sketch), member.robot.name, member.target, {}, {}});
    if (!member.remark.empty())
      complain(fmt::format("robosim: {}: {}\n", fleet.members[i].name, member.remark));
  }
  const record::RecordedRun told = campaign::recorded(fleet, run, runner.hello().version);
  recorders.begin(told);
  const auto on_event = [&](const wire::Event& event) {
    recorders.add(event);
    const auto row = [&](int agent) { return &report.rows.at(static_cast<std::size_t>(agent)); };
    if (const auto* started = std::get_if<wire::Started>(&event); started && started->agent == 0)
      report.started = *started;
    if (const auto* note = std::get_if<wire::Note>(&event)) row(note->agent)->trail.add(*note);
    const auto* sample = std::get_if<wire::Sample>(&event);
    if (!sample) return;
    if (draws) row(sample->agent)->trail.add(*sample);
    if (sample->agent == 0) progress.advance(sample->t_us, static_cast<double>(common.for_ns) * 1e-9);
  };
  const double began_s = 1e-6 * static_cast<double>(wall_us());
  result::RunResult result;
  try {
    const client::Interrupts interrupts(runner);
    if (arguments.live)
      result = run_live(runner, told, on_event);
    else if (arguments.view)
      result = watch(runner, run, fleet, arguments, on_event);
    else
      result = runner.run(run.request, on_event);
  } catch (const InputError& error) {
    throw launch::with_place(fleet, error);
  }
  if (arguments.timing) report.wall_s = 1e-6 * static_cast<double>(wall_us()) - began_s;
  progress.clear();
  std::exception_ptr unwritten;  // write error, reported after the verdicts
  try {
    recorders.finish(result);
  } catch (const InputError&) {
    unwritten = std::current_exception();
  }
  std::vector<result::RunResult> results = launch::results_of(std::move(result));
  for (result::RunResult& one : results) one.next = campaign::next_of(one);

  if (arguments.json) {
    std::vector<launch::RobotRun> robots;
    for (std::size_t i = 0; i < results.size(); ++i)
      robots.push_back(
          {fleet.members[i].name, launch::inputs_of(run.members[i], runner.hello().version), results[i]});
    print(launch::fleet_json(robots, report.wall_s));
  } else if (!arguments.live) {
    for (std::size_t i = 0; i < results.size(); ++i) report.rows[i].result = results[i];
    const ScreenSize screen = screen_size();
    const auto drawn = map_to_draw(run.request);
    print_coloured(terminal::fleet_screen(report, drawn.get(), screen.columns, screen.look));
    if (!unwritten) print(written_text(arguments));
  }
  if (client::Interrupts::signal() == SIGTERM || client::Interrupts::signal() == SIGHUP)
    ::raise(client::Interrupts::signal());
  if (unwritten) std::rethrow_exception(unwritten);
  return status_of(results);
}

}  // namespace robosim::cli
