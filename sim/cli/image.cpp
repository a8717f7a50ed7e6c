#include "sim/cli/image.h"

#include <fmt/format.h>

#include <cstdio>

#include "sim/base/file.h"
#include "sim/client/runner.h"

namespace robosim::cli {

const BoardSpec& board_of(const client::RobotInfo& robot) {
  const BoardSpec* board = find_board(robot.board.name.c_str());
  if (!board)
    throw client::RunnerError("the runner named a board that this program lacks: " + robot.board.name);
  return *board;
}

sketch::Image image_of(const SketchChoice& sketch, const sketch::Request& request, Progress& progress,
                       bool warnings) {
  if (!sketch.elf_target.empty()) {
    sketch::Image image;
    image.name = sketch.name;
    image.image = sketch.path;
    image.sketch_sha256 = sha256_of_file(sketch.path);
    return image;
  }
  progress.say("compiling " + sketch.name + " …");
  sketch::Image image = sketch::build(request);
  progress.clear();
  if (warnings && !image.messages.empty()) fmt::print(stderr, "{}", image.messages);
  return image;
}

}  // namespace robosim::cli
