#include "sim/cli/wire/wire_command.h"

#include <fmt/format.h>

#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/build/cache.h"
#include "sim/campaign/wiring/candidate_trial.h"
#include "sim/cli/launching.h"
#include "sim/cli/options.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

const BoardSpec& board_named(const std::string& name) {
  if (name.empty()) return *board_at(0);
  std::vector<std::string> names;
  for (int i = 0; board_at(i) != nullptr; ++i) names.emplace_back(board_at(i)->name);
  check_choice("--board", name, names);
  return *find_board(name.c_str());
}

std::string what_came_of_it(const result::RunResult& result, bool follows, const std::string& map) {
  if (result.verdict == "reached" && !follows)
    return fmt::format(
        "With this robot the sketch drives around the map {}, but hardly along the line: its sensors are "
        "{:.0f} "
        "mm off it on average, and for {:.0f} of {:.0f} s none of them saw it.",
        map, result.metrics.cross_track_rms_mm, result.metrics.off_line_s, result.time_s);
  if (result.verdict == "reached")
    return fmt::format("With this robot the sketch drives a lap of the map {} in {:.1f} s.", map,
                       result.metrics.laps_s.empty() ? result.time_s : result.metrics.laps_s[0]);
  return fmt::format("With this robot the sketch does not drive a lap of the map {}: {}", map, result.why);
}

}  // namespace

int wire_command(const WireArguments& arguments) {
  if (!arguments.out.empty() && fs::exists(arguments.out))
    throw InputError({arguments.out, 0, 0},
                     "exists already; nothing was written; remove it, or name another --out");
  if (!arguments.out.empty()) check_can_be_written(arguments.out);
  const project::Project project = launch::choose_sketch(arguments.sketch, arguments.environment).project;
  if (arguments.board.empty()) project::check_board(project);
  const BoardSpec& board =
      arguments.board.empty() && project.board ? *project.board : board_named(arguments.board);
  launch::Launch launch;
  launch.environment = arguments.environment;
  launch.sketch = arguments.sketch;
  launch.map = arguments.map;
  launch.target = arguments.target.empty() ? "host" : arguments.target;
  launch.libraries = arguments.libraries;
  terminal::Progress progress(true);
  const build::Cache cache(build::cache_folder());
  const build::WorkFolder scratch(cache);
  wiring::CandidateTrial try_out(launch, board, scratch.path(),
                                 listener_of(progress, {.choices = false, .warnings = false}));
  progress.say("watching the sketch's pins …");
  wiring::RobotDraft draft = try_out.draft();
  progress.say("trying polarities and sides …");
  const result::RunResult drive = try_out.choose(draft);
  progress.clear();

  std::vector<std::string> remarks = {
      "Drafted by `robosim wire` from the sketch's names and from its use of the pins in a run.",
      "Look at every line with a question mark. Keys and units: docs/reference/robots.md, \"Your robot, step "
      "by step\"."};
  if (!draft.parts.empty()) remarks.push_back(what_came_of_it(drive, try_out.follows(), arguments.map));
  if (try_out.tried() > 1)
    remarks.push_back(fmt::format(
        "{} wirings were tried (polarity and order of the sensors, sides of the motors); {}.",
        try_out.tried(),
        try_out.follows() ? "this one drives a lap"
                          : "none follows the line for a lap, and none is much better than this one"));
  const std::string text = wiring::text_of(draft, remarks);
  if (arguments.out.empty()) {
    print(text);
  } else {
    write_file(arguments.out, text);
    print(arguments.out + " is written; look at its lines with a question mark\n");
  }
  return 0;
}

}  // namespace robosim::cli
