#include "sim/cli/build_command.h"

#include <fmt/format.h>

#include "sim/cli/names.h"
#include "sim/cli/output.h"
#include "sim/cli/progress.h"
#include "sim/client/runner.h"

namespace robosim::cli {
namespace {

sketch::Warnings warnings_of(const std::string& level) {
  if (level == "none") return sketch::Warnings::none;
  if (level == "more") return sketch::Warnings::more;
  if (level == "all") return sketch::Warnings::all;
  return sketch::Warnings::standard;
}

const BoardSpec& board_of(const Choice& robot, const std::string& target) {
  client::Runner runner(target);
  const std::string name = runner.describe_robot(robot.path.string()).board.name;
  const BoardSpec* board = find_board(name.c_str());
  if (!board) throw client::RunnerError("the runner named a board that this program lacks: " + name);
  return *board;
}

}  // namespace

std::string size_report(const std::string& sketch, const sketch::Image& image, const BoardSpec& board) {
  std::string text = fmt::format("{}: {} bytes of code and {} bytes of variables on this machine ({}{})\n",
                                 sketch, image.text_bytes, image.data_bytes, image.compiler,
                                 image.from_cache ? ", unchanged since it was last compiled" : "");
  if (!image.libraries.empty()) text += fmt::format("libraries: {}\n", fmt::join(image.libraries, ", "));
  text += fmt::format("image: {}\n", image.image.string());
  text += fmt::format(
      "How much of the {}'s {} bytes of flash and {} bytes of RAM it takes, --target avr will tell; this "
      "version "
      "builds for host only.\n",
      board.name, board.flash_bytes, board.ram_bytes);
  return text;
}

int build_command(const BuildArguments& arguments) {
  check_target(arguments.target);
  const SketchChoice sketch = choose_sketch(arguments.sketch);
  const Choice robot = choose_robot(arguments.robot, sketch.folder);
  const BoardSpec& board = board_of(robot, arguments.target);
  sketch::Request request{sketch.path, board, arguments.target, {}, warnings_of(arguments.warnings)};
  for (const std::string& folder : arguments.libraries) request.libraries.emplace_back(folder);

  Progress progress(true);
  progress.say("compiling " + sketch.name + " …");
  const sketch::Image image = sketch::build(request);
  progress.clear();
  fmt::print(stderr, "{}", image.messages);
  print(size_report(sketch.name, image, board));
  return 0;
}

}  // namespace robosim::cli
