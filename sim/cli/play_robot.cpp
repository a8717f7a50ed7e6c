#include "sim/cli/play_robot.h"

#include <fmt/format.h>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/cli/interrupts.h"
#include "sim/client/runner.h"
#include "sim/sketch/sketch.h"
#include "sim/view/live_view.h"

namespace robosim::cli {
namespace {

/// What drives a robot as an algorithm does.
struct Act {
  const char* sketch;
  const char* robot;
  const char* script;
};

Act act_of(view::Algorithm algorithm) {
  switch (algorithm) {
    case view::Algorithm::left:
      return {"LeftPath", "uno3", ""};
    case view::Algorithm::right:
      return {"RightPath", "uno3", ""};
    case view::Algorithm::ai:
      break;
  }
  return {"AiNavigator", "uno5", "at 1s press start 100ms\n"};
}

}  // namespace

std::string play_robot(const grid::Map& map, const grid::Start& start, view::Algorithm algorithm,
                       view::Console& console) {
  const Act act = act_of(algorithm);
  client::Runner runner("host");
  const client::RobotInfo robot = runner.describe_robot(act.robot);
  const BoardSpec* board = find_board(robot.board.name.c_str());
  if (!board)
    throw client::RunnerError("the runner named a board that this program lacks: " + robot.board.name);
  const sketch::Image image = sketch::build({sketch::find_sketch(act.sketch), *board});

  client::RunRequest request;
  request.image = image.image.string();
  request.map = map.file;
  request.robot = act.robot;
  request.start = fmt::format("{},{},{}", start.cell.x, start.cell.y, grid::letter(start.facing));
  request.goal = "tour";
  request.script = act.script;
  request.notes = request.serial = console.is_live();
  request.samples_every_ns = console.is_live() ? view::kViewEvery_ns : 0;

  client::RunResult result;
  int signal = 0;
  console.lend([&] {
    const Interrupts interrupts(runner);
    if (console.is_live()) {
      runner.keep_close();
      view::LiveScene scene(fmt::format("{} · {} on {}", act.sketch, act.robot, map.name), map, robot);
      view::LiveView live(
          scene, {1.0, console.look(), [] { return Interrupts::count() > 0; }, [&] { runner.interrupt(); }});
      result = runner.run(request, [&](const client::Event& event) { live.on_event(event); });
      live.finish(result);
    } else {
      result = runner.run(request);
    }
    signal = Interrupts::signal();
  });
  if (signal != 0) throw view::SessionQuit{true};
  return fmt::format("{}: {} Time: {:.2f} s, {:.2f} m.", result.verdict, result.why, result.time_s,
                     result.metrics.distance_m);
}

}  // namespace robosim::cli
