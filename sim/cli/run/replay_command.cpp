#include "sim/cli/run/replay_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/cli/output.h"
#include "sim/cli/run/recorders.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/fleet.h"
#include "sim/record/record_page.h"
#include "sim/record/record_trace.h"
#include "sim/record/recording.h"
#include "sim/record/track.h"
#include "sim/view/terminal/fleet_report.h"
#include "sim/view/terminal/live_view.h"
#include "sim/view/terminal/report.h"

namespace robosim::cli {
namespace {

constexpr int kWidestEnd_columns = 78;

/// Thrown to stop the playback when the user quits.
struct Left {};

/// Returns the robots' names if there are several; otherwise empty.
std::vector<std::string> names_of(const record::RecordingHeader& header) {
  std::vector<std::string> names;
  for (std::size_t i = 0; !header.others.empty() && i < header.robot_count(); ++i)
    names.push_back(header.of(i).name);
  return names;
}

/// Combines the results of all robots into one result.
result::RunResult whole_result(const record::RecordingHeader& header) {
  result::RunResult result = header.result;
  wire::RunRequest request;
  request.name = header.name;
  for (const record::RobotRecord& other : header.others) {
    result.others.push_back(other.result);
    request.agents.emplace_back().name = other.name;
  }
  return launch::whole_of(result, request);
}

void watch(const record::Recording& recording, const map::Map& map, double speed) {
  const record::RecordingHeader& header = recording.header();
  const std::vector<std::string> names = names_of(header);
  const std::string title =
      names.empty() ? fmt::format("{} · {} on {}", header.sketch, header.robot, header.map)
                    : fmt::format("{} robots on {}; below: {}", names.size(), header.map, names.front());
  terminal::LiveScene scene(title, map, header.robot_info, names);
  bool left = false;
  terminal::LiveView view(
      scene, {speed, terminal::look_from_environment(true), [&] { return left; }, [&] { left = true; }});
  try {
    recording.play([&](const wire::Event& event) {
      view.on_event(event);
      if (left) throw Left{};
    });
  } catch (const Left&) {
    return;
  }
  view.finish(whole_result(header));
}

/// Writes the recording to the files of --record, in the format of each file's ending.
void write(const record::Recording& recording, const ReplayArguments& arguments, const record::Over* over) {
  for (const std::string& file : arguments.record) {
    const FileLock claim(file);
    if (file.ends_with(".html"))
      write_file(file, record::page_of(record::recording_in(read_file(arguments.file)), over));
    else if (file.ends_with(".rec"))
      write_file(file, record::recording_in(read_file(arguments.file)));
    else
      record::write_trace(recording, file);
  }
}

void check_endings(const std::vector<std::string>& files) {
  static const std::vector<std::string> known{".html", ".rec", ".perfetto.json"};
  for (const std::string& file : files)
    if (std::none_of(known.begin(), known.end(), [&](const std::string& e) { return file.ends_with(e); }))
      throw InputError(fmt::format("--record: {}: expected a name that ends in {}", file, one_of(known)));
}

std::string apart_text(const record::Apart& a) {
  if (a.from_1mm_s < 0.0) return fmt::format("never 1 mm, in {:.2f} s\n", a.until_s);
  return fmt::format(
      "1 mm at {:.2f} s, at most {:.0f} mm at {:.2f} s; {:.0f} mm in the mean, until {:.2f} s\n",
      a.from_1mm_s, a.most_mm, a.most_s, a.mean_mm, a.until_s);
}

/// Compares each robot with the robot of the same name in the other recording.
std::string apart_text(const record::Recording& one, const std::vector<record::Track>& others,
                       const std::string& file) {
  std::string text;
  for (std::size_t i = 0; i < one.header().robot_count(); ++i) {
    const std::string& name = one.header().of(i).name;
    const auto other = std::find_if(others.begin(), others.end(),
                                    [&](const record::Track& track) { return track.robot == name; });
    if (other == others.end()) continue;
    const std::string whose = name.empty() ? "" : name + " ";
    text += fmt::format("\n{}over it: {}: {}\n{}apart:   {}", whose, file, other->what, whose,
                        apart_text(record::apart(record::track_of(one, i), *other)));
  }
  if (text.empty()) {
    const auto named = [](const std::string& name) { return name.empty() ? "one without a name" : name; };
    std::vector<std::string> here, there;
    for (std::size_t i = 0; i < one.header().robot_count(); ++i)
      there.push_back(named(one.header().of(i).name));
    for (const record::Track& track : others) here.push_back(named(track.robot));
    throw InputError(
        {file}, fmt::format("no robot is in both runs: expected {}, got {}", one_of(there), one_of(here)));
  }
  return text;
}

std::string end_screen(const record::Recording& recording, const map::Map* map, std::int64_t every_us,
                       int columns, terminal::Look look) {
  const record::RecordingHeader& header = recording.header();
  terminal::Report report;
  report.sketch = header.sketch;
  report.map = header.map;
  report.robot = header.robot;
  report.target = header.target;
  report.started = header.started;
  report.result = header.result;
  recording.play([&](const wire::Event& event) {
    const auto* sample = std::get_if<wire::Sample>(&event);
    if (sample && sample->t_us % every_us == 0) report.trail.add(*sample);
    if (const auto* note = std::get_if<wire::Note>(&event)) report.trail.add(*note);
  });
  const BoardSpec* board = find_board(header.robot_info.board.name.c_str());
  report.sees_lines = !header.robot_info.sensors.empty();
  report.chip_target = board ? board->chip->target : header.target;
  report.board = header.robot_info.board.name;
  report.chip_ram_bytes = board ? board->ram_bytes : 0;
  return terminal::end_screen(report, map, columns, look);
}

std::string fleet_screen(const record::Recording& recording, const map::Map* map, std::int64_t every_us,
                         int columns, terminal::Look look) {
  const record::RecordingHeader& header = recording.header();
  terminal::FleetReport report;
  report.map = header.map;
  report.started = header.started;
  for (std::size_t i = 0; i < header.robot_count(); ++i) {
    const record::RobotRecord& robot = header.of(i);
    report.rows.push_back({robot.name, robot.sketch, robot.robot, robot.target, robot.result, {}});
  }
  const auto trail = [&](int agent) -> terminal::Trail& {
    return report.rows.at(static_cast<std::size_t>(agent)).trail;
  };
  recording.play([&](const wire::Event& event) {
    const auto* sample = std::get_if<wire::Sample>(&event);
    if (sample && sample->t_us % every_us == 0) trail(sample->agent).add(*sample);
    if (const auto* note = std::get_if<wire::Note>(&event)) trail(note->agent).add(*note);
  });
  return terminal::fleet_screen(report, map, columns, look);
}

}  // namespace

int replay_command(const ReplayArguments& arguments) {
  check_endings(arguments.record);
  const record::Recording recording = record::Recording::read(arguments.file);
  record::Over over;
  std::optional<std::string> apart;
  if (!arguments.over.empty()) {
    over.name = std::filesystem::path(arguments.over).filename();
    apart = apart_text(recording, record::read_tracks(arguments.over, &over.bytes), arguments.over);
  }
  write(recording, arguments, apart ? &over : nullptr);
  const record::RecordingHeader& header = recording.header();
  std::optional<map::Map> map;
  const bool has_picture = header.floor && header.floor->picture;
  if (!header.map_text.empty())
    map = map::parse_map(header.map_text, header.map,
                         has_picture ? from_base64(header.floor->picture->png) : "",
                         {header.result.seed, profile_of(header.result.profile)});
  const bool on_terminal = ::isatty(STDOUT_FILENO) != 0;
  if (on_terminal && map) watch(recording, *map, arguments.speed);

  const auto size = terminal::terminal_size(STDOUT_FILENO);
  const int columns = std::min(size ? size->columns - 1 : kWidestEnd_columns, kWidestEnd_columns);
  const terminal::Look look = terminal::look_from_environment(size.has_value());
  const std::int64_t every_us =
      terminal::trail_every_ns(static_cast<std::int64_t>(header.result.for_s * 1e9)) / 1000;
  print_coloured(header.others.empty()
                     ? end_screen(recording, map ? &*map : nullptr, every_us, columns, look)
                     : fleet_screen(recording, map ? &*map : nullptr, every_us, columns, look));
  if (apart) print(*apart);
  print(written_text(arguments.record));
  return 0;
}

}  // namespace robosim::cli
