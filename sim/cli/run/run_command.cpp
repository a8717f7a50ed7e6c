#include "sim/cli/run/run_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <system_error>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/cli/output.h"
#include "sim/cli/run/coverage.h"
#include "sim/cli/run/debugger.h"
#include "sim/cli/run/run_json.h"
#include "sim/cli/run/second_look.h"
#include "sim/client/runner.h"
#include "sim/launch/image.h"
#include "sim/launch/interrupts.h"
#include "sim/launch/names.h"
#include "sim/launch/progress.h"
#include "sim/record/record_csv.h"
#include "sim/record/record_vcd.h"
#include "sim/tui/live_view.h"
#include "sim/tui/report.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr int kWidest_columns = 78;
// The end screen's trail: coarse enough to cost nothing, fine enough for a picture of a few centimetres a
// dot.
constexpr std::int64_t kTrailEvery_ns = 50'000'000;
constexpr std::int64_t kTrailSamples = 20'000;
// Above this a picture of the map takes longer than the run.
constexpr std::uintmax_t kLargestPicturedMap_bytes = 4'000'000;

double wall_now_s() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// How often samples are needed, as a multiple of 1 ms; 0 = not at all.
std::int64_t samples_every_ns(const RunArguments& arguments, bool progress) {
  if (!arguments.record.empty()) return record::kRecordEvery_ns;
  if (arguments.view) return tui::kViewEvery_ns;
  if (arguments.json && !progress) return 0;
  constexpr std::int64_t kTick = 1'000'000;
  return std::max(kTrailEvery_ns, arguments.for_ns / kTrailSamples / kTick * kTick);
}

/// RAM that neither variables nor the deepest stack took.
std::optional<std::int64_t> free_bytes(const wire::RunResult& result, const BoardSpec& board) {
  if (!result.resources) return std::nullopt;
  const std::int64_t used = result.resources->ram_bytes + result.resources->stack_bytes_max;
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(board.ram_bytes) - used);
}

/// How far the limits might be raised that the firmware states.
std::vector<tui::Room> rooms(const build::Image& image, std::optional<std::int64_t> free) {
  std::vector<tui::Room> rooms;
  if (!free) return rooms;
  for (const build::Limit& limit : build::stated_limits(image)) {
    if (limit.bytes_each == 0) continue;
    const std::uint64_t fit = limit.value + static_cast<std::uint64_t>(*free) / limit.bytes_each;
    rooms.push_back({limit.what, limit.value, std::min(fit, limit.most), limit.bytes_each});
  }
  return rooms;
}

/// The map for pictures; null if it is too large for one.
std::unique_ptr<grid::Map> map_to_draw(const fs::path& path) {
  std::error_code error;
  const auto bytes = fs::file_size(path, error);
  if (error || bytes > kLargestPicturedMap_bytes) return nullptr;
  return std::make_unique<grid::Map>(grid::read_map(path));
}

bool is_vcd(const std::string& file) { return fs::path(file).extension() == ".vcd"; }

/// Everything that listens to a run's events.
class Listeners {
 public:
  Listeners(const RunArguments& arguments, const BoardSpec& board, launch::Progress& progress)
      : progress_(progress) {
    for (const std::string& file : arguments.record) {
      if (is_vcd(file)) {
        waves_.emplace_back(file, board);
      } else {
        tables_.emplace_back(file);
      }
    }
    for_s_ = static_cast<double>(arguments.for_ns) * 1e-9;
  }

  void watch(tui::LiveView* view) { view_ = view; }
  void name_debugger(std::string command) { debugger_ = std::move(command); }

  void on_event(const wire::Event& event) {
    for (record::CsvRecord& table : tables_) table.add(event);
    for (record::VcdRecord& wave : waves_) wave.add(event);
    if (const auto* started = std::get_if<wire::Started>(&event)) started_ = *started;
    if (const auto* sample = std::get_if<wire::Sample>(&event)) {
      trail_.add(*sample);
      if (!view_) progress_.advance(sample->t_us, for_s_);
    }
    if (std::holds_alternative<wire::DebuggerAwaited>(event)) {
      progress_.clear();
      fmt::print(stderr, "robosim: waiting for a debugger; in another terminal type: {}\n", debugger_);
    }
    if (view_) view_->on_event(event);
  }

  void save() const {
    for (const record::CsvRecord& table : tables_) table.save();
    for (const record::VcdRecord& wave : waves_) wave.save();
  }
  const wire::Started& started() const { return started_; }
  const tui::Trail& trail() const { return trail_; }

 private:
  launch::Progress& progress_;
  std::vector<record::CsvRecord> tables_;
  std::vector<record::VcdRecord> waves_;
  tui::LiveView* view_ = nullptr;
  std::string debugger_;  ///< what to type to attach one
  wire::Started started_;
  tui::Trail trail_;
  double for_s_ = 0.0;
};

/// Runs, in the live view if asked for.
wire::RunResult simulate(client::Runner& runner, const wire::RunRequest& request,
                         const RunArguments& arguments, const std::string& title,
                         const wire::RobotInfo& robot, const fs::path& map, Listeners& listeners) {
  const launch::Interrupts interrupts(runner);
  const auto on_event = [&](const wire::Event& event) { listeners.on_event(event); };
  if (!arguments.view) return runner.run(request, on_event);

  runner.keep_close();
  const grid::Map floor = grid::read_map(map);
  tui::LiveScene scene(title, floor, robot);
  tui::LiveView live(scene, {arguments.speed, tui::look_from_environment(true),
                             [] { return launch::Interrupts::count() > 0; }, [&] { runner.interrupt(); }});
  listeners.watch(&live);
  const wire::RunResult result = runner.run(request, on_event);
  live.finish(result);
  listeners.watch(nullptr);
  return result;
}

}  // namespace

std::string scenario_text(const RunArguments& arguments) {
  std::string text;
  if (!arguments.script.empty()) text = read_file(arguments.script);
  if (!text.empty() && text.back() != '\n') text += '\n';
  for (const std::string& send : arguments.send) text += fmt::format("at 1s send \"{}\"\n", send);
  return text;
}

int run_command(const RunArguments& given) {
  RunArguments arguments = given;
  launch::check_target(arguments.target);
  for (const std::string& file : arguments.record) record::check_record_ending(file);
  if (arguments.view && ::isatty(STDOUT_FILENO) == 0) {
    throw InputError(
        "--view needs a terminal, and the standard output is none; leave --view out, or do not redirect it");
  }
  const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch);
  if (!sketch.elf_target.empty()) {
    if (arguments.target != "host" && arguments.target != sketch.elf_target) {
      throw InputError({sketch.name, 0, 0}, fmt::format("is for the target {}, and --target asks for {}",
                                                        sketch.elf_target, arguments.target));
    }
    arguments.target = sketch.elf_target;
    launch::check_target(arguments.target);
  }
  check_debugger(arguments.gdb_port, arguments.target);
  if (arguments.sanitize) build::check_can_sanitize(arguments.target);
  arguments.coverage = coverage_folder(given.coverage, arguments.target);
  std::optional<CounterFile> counters;
  if (!arguments.coverage.empty()) counters.emplace(arguments.coverage);
  const launch::Choice map = launch::choose_map(arguments.map, sketch.folder);
  const launch::Choice robot_choice = launch::choose_robot(arguments.robot, sketch.folder, arguments.target);
  for (const launch::Choice* choice : {&map, &robot_choice}) {
    if (!choice->announcement.empty()) fmt::print(stderr, "robosim: {}\n", choice->announcement);
  }
  wire::RunRequest request;
  request.script = scenario_text(arguments);
  request.script_file = arguments.script.empty() ? "--send" : arguments.script;

  launch::Progress progress(!arguments.view);
  client::Runner runner(arguments.target);
  const launch::Carrier carrier = fit_to_target(
      robot_choice, arguments.target, [&](const std::string& name) { return runner.describe_robot(name); });
  if (!carrier.announcement.empty()) fmt::print(stderr, "robosim: {}\n", carrier.announcement);
  const launch::Choice& robot = carrier.robot;
  const wire::RobotInfo& robot_info = carrier.info;
  build::Request wanted{sketch.path, launch::board_of(robot_info), arguments.target};
  for (const std::string& folder : arguments.libraries) wanted.libraries.emplace_back(folder);
  wanted.sanitize = arguments.sanitize;
  wanted.coverage = !arguments.coverage.empty();
  const build::Image image = image_of(sketch, wanted, progress);

  request.image = image.image.string();
  if (counters) request.counters = counters->path().string();
  request.map = map.path.string();
  request.robot = robot.path.string();
  request.start = arguments.start;
  request.goal = arguments.goal;
  request.for_ns = arguments.for_ns;
  request.seed = arguments.seed;
  request.clock_ns = arguments.clock_ns;
  request.gdb_port = arguments.gdb_port;
  request.profile = arguments.profile;
  request.samples_every_ns = samples_every_ns(arguments, progress.active());
  request.serial = request.notes = arguments.view;
  request.pins = request.io = std::any_of(arguments.record.begin(), arguments.record.end(), is_vcd);

  Listeners listeners(arguments, launch::board_of(robot_info), progress);
  if (arguments.gdb_port > 0)
    listeners.name_debugger(debugger_command(image.image, sketch.elf_target.empty() ? sketch.folder : "",
                                             arguments.target, arguments.gdb_port));
  const double began_s = wall_now_s();
  const std::string title = fmt::format("{} · {} on {}", sketch.name, robot.name, map.name);
  wire::RunResult result = simulate(runner, request, arguments, title, robot_info, map.path, listeners);
  std::optional<double> wall_s;
  if (arguments.timing) wall_s = wall_now_s() - began_s;
  progress.clear();
  listeners.save();
  std::optional<Finding> finding;
  if (arguments.target == "avr" && sketch.elf_target.empty() && deserves_second_look(result)) {
    progress.say("running " + sketch.name + " again, with checks …");
    finding = look_again(runner, request, wanted, result);
    progress.clear();
    result.next = next_after(result, finding);
  }

  const auto json = [&](std::optional<double> timing) {
    return run_json({runner.hello().version, arguments.target, sketch.name, map.name, robot.name,
                     image.sketch_sha256, image.compiler, arguments.sanitize},
                    result, timing, finding);
  };
  if (arguments.json) {
    print(json(wall_s));
  } else {
    const auto size = tui::terminal_size(STDOUT_FILENO);
    const int columns = std::min(size ? size->columns - 1 : kWidest_columns, kWidest_columns);
    const auto drawn = map_to_draw(map.path);
    const auto free = free_bytes(result, launch::board_of(robot_info));
    print(tui::end_screen(
        {sketch.name, map.name, robot.name, arguments.target, listeners.started(), result, listeners.trail(),
         wall_s, free, rooms(image, free), launch::chip_target_of(launch::board_of(robot_info))},
        drawn.get(), columns, tui::look_from_environment(size.has_value())));
  }
  if (counters) {
    // The same run counts once: what went into it, and what came out.
    const std::string text = counters->keep(wanted, image, request.script + json(std::nullopt));
    if (!given.coverage.empty())
      fmt::print(arguments.json ? stderr : stdout, "{}{}", text, counters->make_page());
  }
  if (launch::Interrupts::signal() == SIGTERM || launch::Interrupts::signal() == SIGHUP)
    ::raise(launch::Interrupts::signal());
  return result.status;
}

}  // namespace robosim::cli
