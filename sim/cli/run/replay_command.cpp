#include "sim/cli/run/replay_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/cli/output.h"
#include "sim/client/interrupts.h"
#include "sim/record/recording.h"
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

}  // namespace

int replay_command(const ReplayArguments& arguments) {
  const record::Recording recording = record::Recording::read(arguments.file);
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
  return 0;
}

}  // namespace robosim::cli
