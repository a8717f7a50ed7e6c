#include "sim/cli/files/robot_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "sim/base/file.h"
#include "sim/base/parse_unsigned.h"
#include "sim/base/robot_name.h"
#include "sim/cli/output.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/fit_robot.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace {

/// Returns the first comment line of a file, without its '#'.
std::string first_comment(const std::string& text) {
  if (text.empty() || text[0] != '#') return "";
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t begin = line.find_first_not_of("# ");
  return begin == std::string::npos ? "" : line.substr(begin);
}

void list() {
  const auto names = launch::names_in(launch::stock_robot_folder(), ".toml");
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  std::string text;
  for (const std::string& name : names) {
    text += fmt::format("{:<{}}  {}\n", name, longest,
                        first_comment(read_file(launch::stock_robot_folder() / (name + ".toml"))));
  }
  print(text);
}

void show(const std::string& robot) {
  print(read_file(launch::is_path(robot) ? std::filesystem::path(robot)
                                         : launch::stock_robot_folder() / (robot + ".toml")));
}

/// Formats a pin for display: "D5 (PD5)" for a pin number; a shift register's pin stays unchanged.
std::string pin_name(const BoardSpec& board, const std::string& pin) {
  const std::optional<std::uint64_t> number = parse_unsigned(pin);
  if (!number || *number >= board.pin_count) return pin;
  const PinSpec& spec = board.pins[*number];
  return fmt::format("{} ({})", spec.name, spec.chip_name);
}

void check(const launch::Choice& robot) {
  client::Runner runner(client::available_targets().front());
  const wire::RobotInfo info = runner.describe_robot(robot.path.string());
  std::size_t longest = 0;
  for (const auto& part : info.parts) longest = std::max(longest, part.name.size());
  std::string text =
      fmt::format("{} is fine: {}, board {} ({}), {} parts, {} line sensors\n", robot.name, info.name,
                  info.board.name, info.board.fqbn, info.parts.size(), info.sensors.size());
  for (const auto& part : info.parts) {
    text += fmt::format("  {:<{}}  {:<18}", part.name, longest, part.type);
    for (const auto& [use, pin] : part.pins)
      text += fmt::format(" {} {}", use, pin_name(launch::board_of(info), pin));
    text += '\n';
  }
  print(text);
}

}  // namespace

int robot_command(const RobotArguments& arguments) {
  if (arguments.action == "list") {
    list();
    return 0;
  }
  const launch::Choice robot = launch::choose_robot(arguments.robot, ".");
  if (arguments.full) {
    client::Runner runner(client::available_targets().front());
    print(runner.describe_robot(robot.path.string(), true).text);
  } else {
    arguments.action == "show" ? show(parse_robot_name(robot.name).robot) : check(robot);
  }
  return 0;
}

}  // namespace robosim::cli
