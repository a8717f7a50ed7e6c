// The program `robosim`. Performs the commands for one run, and starts robosim-campaign for all others. This
// split shortens the build before a user's first run.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <variant>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/files/build_command.h"
#include "sim/cli/files/flash_command.h"
#include "sim/cli/files/man_command.h"
#include "sim/cli/files/map_command.h"
#include "sim/cli/files/new_command.h"
#include "sim/cli/files/robot_command.h"
#include "sim/cli/output.h"
#include "sim/cli/program.h"
#include "sim/cli/run/classic_command.h"
#include "sim/cli/run/play_command.h"
#include "sim/cli/run/replay_command.h"
#include "sim/cli/run/run_command.h"
#include "sim/cli/run/why_command.h"
#include "sim/cli/serve/serve_command.h"

namespace robosim::cli {
namespace {

/// Replaces this process by robosim-campaign. Throws ToolMissing if it cannot be started.
[[noreturn]] void start_campaign(char** words) {
  const std::filesystem::path program = helper_folder() / "robosim-campaign";
  ::execv(program.c_str(), words);
  throw ToolMissing(program.string() + " cannot be started: " + std::strerror(errno) +
                    "; this command requires it: build or install all of Robosim");
}

struct Perform {
  char** words;

  int operator()(const RunArguments& arguments) const { return run_command(arguments); }
  int operator()(const WhyArguments& arguments) const { return why_command(arguments); }
  int operator()(const ReplayArguments& arguments) const { return replay_command(arguments); }
  int operator()(const ClassicArguments& arguments) const { return classic_command(arguments); }
  int operator()(const BuildArguments& arguments) const { return build_command(arguments); }
  int operator()(const FlashArguments& arguments) const { return flash_command(arguments); }
  int operator()(const MapArguments& arguments) const { return map_command(arguments); }
  int operator()(const GenerateArguments& arguments) const { return generate_command(arguments); }
  int operator()(const RobotArguments& arguments) const { return robot_command(arguments); }
  int operator()(const PlayArguments& arguments) const { return play_command(arguments); }
  int operator()(const ServeArguments& arguments) const { return serve_command(arguments); }
  int operator()(const NewArguments& arguments) const { return new_command(arguments); }
  int operator()(const ManArguments& arguments) const { return man_command(arguments); }
  int operator()(const PrintText& text) const {
    print(text.text);
    return 0;
  }
  template <typename Arguments>
  int operator()(const Arguments&) const {
    start_campaign(words);
  }
};

}  // namespace
}  // namespace robosim::cli

int main(int count, char** words) {
  namespace cli = robosim::cli;
  return cli::run_program(
      count, words, [&](const cli::Command& command) { return std::visit(cli::Perform{words}, command); });
}
