#include "sim/cli/run/run_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/base/wall_clock.h"
#include "sim/build/sketch.h"
#include "sim/campaign/rerun/recorded.h"
#include "sim/campaign/rerun/sanitizer_rerun.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/cli/run/coverage.h"
#include "sim/cli/run/debugger.h"
#include "sim/cli/run/end_screen.h"
#include "sim/cli/run/fleet_command.h"
#include "sim/cli/run/live.h"
#include "sim/cli/run/recorders.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/launch/names.h"
#include "sim/launch/run_json.h"
#include "sim/record/recorder.h"
#include "sim/result/advice.h"
#include "sim/view/terminal/live_view.h"
#include "sim/view/terminal/progress.h"
#include "sim/view/terminal/report.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

double wall_now_s() { return 1e-6 * static_cast<double>(wall_us()); }

/// Returns the period of the samples that the run reports, a multiple of 1 ms; 0 = no samples.
std::int64_t samples_every_ns(const RunArguments& arguments, bool progress) {
  if (arguments.view) return terminal::kViewEvery_ns;
  if (arguments.live || (arguments.json && !progress)) return 0;
  return terminal::trail_every_ns(arguments.request.for_ns);
}

/// Returns the highest value that the free RAM permits for each limit of the firmware (build::Limit).
std::vector<terminal::Room> rooms(const build::Image& image, const result::RunResult& result) {
  std::vector<terminal::Room> rooms;
  if (!result.resources) return rooms;
  for (const build::Limit& limit : build::stated_limits(image)) {
    if (limit.bytes_each == 0) continue;
    const std::uint64_t fit =
        limit.value + static_cast<std::uint64_t>(result.resources->free_bytes_min) / limit.bytes_each;
    rooms.push_back({limit.what, limit.value, std::min(fit, limit.most), limit.bytes_each});
  }
  return rooms;
}

/// All listeners of a run's events.
class Listeners {
 public:
  Listeners(record::Recorders& recorders, std::int64_t for_ns, terminal::Progress& progress)
      : recorders_(recorders), progress_(progress), for_s_(static_cast<double>(for_ns) * 1e-9) {}

  void watch(terminal::LiveView* view) { view_ = view; }
  void print_serial() { print_serial_ = true; }
  void finish_serial() { serial_.finish(); }
  void name_debugger(std::string command) { debugger_ = std::move(command); }

  void on_event(const wire::Event& event) {
    recorders_.add(event);
    if (const auto* serial = std::get_if<wire::SerialText>(&event); serial && print_serial_)
      serial_.add(serial->text);
    if (const auto* started = std::get_if<wire::Started>(&event)) started_ = *started;
    if (const auto* sample = std::get_if<wire::Sample>(&event)) add(*sample);
    if (const auto* note = std::get_if<wire::Note>(&event)) notes_.push_back(*note);
    if (std::holds_alternative<wire::DebuggerAwaited>(event)) {
      progress_.clear();
      complain(fmt::format("robosim: waiting for a debugger; in another terminal type: {}\n", debugger_));
    }
    if (view_) view_->on_event(event);
  }

  const wire::Started& started() const { return started_; }
  const terminal::Trail& trail() const { return trail_; }

 private:
  void add(const wire::Sample& sample) {
    for (; !notes_.empty() && notes_.front().t_ns < sample.t_us * 1000; notes_.pop_front())
      trail_.add(notes_.front());
    trail_.add(sample);
    if (!view_) progress_.advance(sample.t_us, for_s_);
  }

  record::Recorders& recorders_;
  terminal::Progress& progress_;
  terminal::LiveView* view_ = nullptr;
  bool print_serial_ = false;
  SerialPrinter serial_;
  std::string debugger_;  ///< the command that attaches a debugger
  wire::Started started_;
  terminal::Trail trail_;
  std::deque<wire::Note> notes_;  ///< notes not yet passed to the trail
  double for_s_;
};

/// Runs the sketch, in the live view if requested.
result::RunResult simulate(client::Runner& runner, const launch::Prepared& run,
                           const record::RecordedRun& recorded, const RunArguments& arguments,
                           Listeners& listeners) {
  const client::Interrupts interrupts(runner);
  const auto on_event = [&](const wire::Event& event) { listeners.on_event(event); };
  if (arguments.live) return run_live(runner, recorded, on_event);
  if (!arguments.view) return runner.run(run.request, on_event);

  runner.keep_close();
  const map::Map floor = map_of(run.request);
  const std::string title =
      fmt::format("{} · {} on {}", launch::title_of(run.sketch), run.robot.name, run.map.name);
  terminal::LiveScene scene(title, floor, run.robot_info);
  terminal::LiveView live(scene,
                          {arguments.speed, terminal::look_from_environment(true),
                           [] { return client::Interrupts::count() > 0; }, [&] { runner.interrupt(); }});
  listeners.watch(&live);
  const result::RunResult result = runner.run(run.request, on_event);
  live.finish(result);
  listeners.watch(nullptr);
  return result;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  if (!arguments.fleet.members.empty()) return fleet_command(arguments);
  record::Recorders recorders = recorders_of(arguments);
  const std::vector<FileLock> claims = claims_of(arguments);
  check_view(arguments);
  launch::Launch launch = launch::launch_of(arguments);
  launch::Chosen chosen = choose(launch);
  check_debugger(launch.request.gdb_port, chosen.target);
  const std::string coverage = coverage_folder(arguments.coverage, chosen.target);
  std::optional<CounterFile> counters;
  if (!coverage.empty()) {
    counters.emplace(coverage);
    launch.count_lines = true;
    launch.request.counters = counters->path().string();
  }
  terminal::Progress progress(!arguments.view && !arguments.live && !arguments.serial);
  launch.request.samples_every_ns = samples_every_ns(arguments, progress.active());
  launch.request.serial = arguments.view || arguments.serial;
  launch.request.notes = true;
  recorders.ask(launch.request);
  launch.request.batches = !arguments.view && !arguments.live;  // viewers need events without delay
  if (arguments.live) launch.request.serial = true, launch.request.columns_every_ns = record::kRecordEvery_ns;

  client::Runner runner(chosen.target);
  launch::Launcher launcher(listener_of(progress));
  const launch::Prepared run = launcher.prepare(
      launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
      runner.hello());
  const BoardSpec& board = launch::board_of(run.robot_info);
  const bool is_built = run.sketch.elf_target.empty();
  const std::string sketch = launch::title_of(run.sketch);

  const record::RecordedRun told = campaign::recorded(run, runner.hello().version);
  recorders.begin(told);
  Listeners listeners(recorders, run.request.for_ns, progress);
  if (arguments.serial) listeners.print_serial();
  if (run.request.gdb_port > 0)
    listeners.name_debugger(debugger_command(run.image.image, is_built ? run.sketch.folder : "", run.target,
                                             run.request.gdb_port));
  const double began_s = wall_now_s();
  result::RunResult result = simulate(runner, run, told, arguments, listeners);
  std::optional<double> wall_s;
  if (arguments.timing) wall_s = wall_now_s() - began_s;
  progress.clear();
  if (!run.remark.empty()) complain(fmt::format("robosim: {}\n", run.remark));
  std::exception_ptr unwritten;  // write error; reported after the verdict, which a full disk does not affect
  try {
    recorders.finish(result);
  } catch (const InputError&) {
    unwritten = std::current_exception();
  }
  std::optional<result::Finding> finding;
  std::string next = campaign::next_of(result);
  if (!arguments.live && is_built && campaign::deserves_sanitizer_rerun(run.wanted, result)) {
    progress.say("running " + sketch + " again, with checks …");
    const campaign::Checked checked =
        campaign::rerun_with_sanitizers(runner, run.request, run.wanted, result);
    progress.clear();
    finding = checked.finding;
    next = campaign::next_after(result, checked);
  }
  if (!arguments.live && is_built && run.target == "host")  // on an AVR, next_after() adds these messages
    next = campaign::after_unset(campaign::unset_variables(run.wanted, result), next);
  result.next = std::move(next);
  if (!arguments.live && is_built && campaign::deserves_detectors(run.wanted, result)) {
    progress.say("running " + sketch + " again, watched by detectors …");
    campaign::AsFlashed flashed = campaign::rerun_with_detectors(runner, run.request, run.wanted, result);
    if (flashed.crashed) result = std::move(*flashed.crashed);
    result.detected = std::move(flashed.detected);
    if (!result.detected.empty()) result.next = result::without_wirings(result.next);
    progress.clear();
  }

  const auto json = [&](std::optional<double> timing) {
    return launch::run_json(launch::inputs_of(run, runner.hello().version), result, timing, finding);
  };
  if (arguments.json) {
    print(json(wall_s));
  } else if (!arguments.live) {
    const ScreenSize screen = screen_size();
    const auto drawn = map_to_draw(run.request);
    listeners.finish_serial();
    (arguments.serial ? complain_coloured : print_coloured)(
        terminal::end_screen({sketch, run.map.name, run.robot.name, run.target, listeners.started(), result,
                              listeners.trail(), wall_s, rooms(run.image, result), board.chip->target,
                              !run.robot_info.sensors.empty(), board.name, board.ram_bytes},
                             drawn.get(), screen.columns, screen.look));
    if (!unwritten) (arguments.serial ? complain : print)(written_text(arguments));
  }
  if (counters) {
    // Describes the run by its inputs and result, so that equal runs are counted only once.
    const std::string text = counters->keep(run.wanted, run.image, run.request.script + json(std::nullopt));
    if (!arguments.coverage.empty()) {
      const std::string shown = text + counters->make_page();
      arguments.json ? complain(shown) : print(shown);
    }
  }
  if (client::Interrupts::signal() == SIGTERM || client::Interrupts::signal() == SIGHUP)
    ::raise(client::Interrupts::signal());
  if (unwritten) std::rethrow_exception(unwritten);
  // With --serial, the end of the sketch's program is a success.
  if (arguments.serial && result.verdict == "ended") return static_cast<int>(ExitStatus::ok);
  return result.status;
}

}  // namespace robosim::cli
