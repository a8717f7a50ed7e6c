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
#include "sim/base/write_claim.h"
#include "sim/cli/output.h"
#include "sim/client/interrupts.h"
#include "sim/record/record_page.h"
#include "sim/record/record_trace.h"
#include "sim/record/recording.h"
#include "sim/record/track.h"
#include "sim/tui/live_view.h"
#include "sim/tui/report.h"

namespace robosim::cli {
namespace {

constexpr int kWidestEnd_columns = 78;

/// Thrown through the recording when the user has seen enough.
struct Left {};

void watch(const record::Recording& recording, const grid::Map& map, double speed) {
  const record::RecordingHeader& header = recording.header();
  tui::LiveScene scene(fmt::format("{} · {} on {}", header.sketch, header.robot, header.map), map,
                       header.robot_info);
  bool left = false;
  tui::LiveView view(scene,
                     {speed, tui::look_from_environment(true), [&] { return left; }, [&] { left = true; }});
  try {
    recording.play([&](const wire::Event& event) {
      view.on_event(event);
      if (left) throw Left{};
    });
  } catch (const Left&) {
    return;
  }
  view.finish(header.result);
}

/// Writes what a recording has in other formats.
void write(const record::Recording& recording, const ReplayArguments& arguments, const record::Over* over) {
  for (const std::string& file : arguments.record) {
    const WriteClaim claim(file);
    if (file.ends_with(".html"))
      write_file(file, record::page_of(record::recording_in(read_file(arguments.file)), over));
    else if (file.ends_with(".rec"))
      write_file(file, record::recording_in(read_file(arguments.file)));
    else
      write_file(file, record::trace_of(recording));
  }
}

void check_endings(const std::vector<std::string>& files) {
  static const std::vector<std::string> known{".html", ".rec", ".perfetto.json"};
  for (const std::string& file : files)
    if (std::none_of(known.begin(), known.end(), [&](const std::string& e) { return file.ends_with(e); }))
      throw InputError("--record: " + file + ": a recording can be written anew as " + one_of(known));
}

std::string apart_text(const record::Track& one, const record::Track& other, const std::string& file) {
  const record::Apart a = record::apart(one, other);
  std::string text = fmt::format("\nover it: {}: {}\n", file, other.what);
  if (a.from_1mm_s < 0.0) return text + fmt::format("apart:   never 1 mm, in {:.2f} s\n", a.until_s);
  return text + fmt::format(
                    "apart:   1 mm at {:.2f} s, at most {:.0f} mm at {:.2f} s; {:.0f} mm in the mean, until "
                    "{:.2f} s\n",
                    a.from_1mm_s, a.most_mm, a.most_s, a.mean_mm, a.until_s);
}

}  // namespace

int replay_command(const ReplayArguments& arguments) {
  check_endings(arguments.record);
  const record::Recording recording = record::Recording::read(arguments.file);
  record::Over over;
  std::optional<std::string> apart;
  if (!arguments.over.empty()) {
    over.name = std::filesystem::path(arguments.over).filename();
    const record::Track other = record::read_track(arguments.over, &over.bytes);
    apart = apart_text(record::track_of(recording), other, arguments.over);
  }
  write(recording, arguments, apart ? &over : nullptr);
  const record::RecordingHeader& header = recording.header();
  std::optional<grid::Map> map;
  const bool has_picture = header.floor && header.floor->picture;
  if (!header.map_text.empty())
    map = grid::parse_map(header.map_text, header.map,
                          has_picture ? from_base64(header.floor->picture->png) : "");
  const bool on_terminal = ::isatty(STDOUT_FILENO) != 0;
  if (on_terminal && map) watch(recording, *map, arguments.speed);

  tui::Report report;
  report.sketch = header.sketch;
  report.map = header.map;
  report.robot = header.robot;
  report.target = header.target;
  report.started = header.started;
  report.result = header.result;
  const std::int64_t every_us =
      tui::trail_every_ns(static_cast<std::int64_t>(header.result.for_s * 1e9)) / 1000;
  recording.play([&](const wire::Event& event) {
    const auto* sample = std::get_if<wire::Sample>(&event);
    if (sample && sample->t_us % every_us == 0) report.trail.add(*sample);
    if (const auto* note = std::get_if<wire::Note>(&event)) report.trail.add(*note);
  });
  const BoardSpec* board = find_board(header.robot_info.board.name.c_str());
  report.sees_lines = !header.robot_info.sensors.empty();
  report.chip_target = board ? board->chip->target : header.target;
  const auto size = tui::terminal_size(STDOUT_FILENO);
  print(tui::end_screen(report, map ? &*map : nullptr,
                        std::min(size ? size->columns - 1 : kWidestEnd_columns, kWidestEnd_columns),
                        tui::look_from_environment(size.has_value())));
  if (apart) print(*apart);
  return 0;
}

}  // namespace robosim::cli
