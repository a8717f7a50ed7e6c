#include "sim/cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace robosim::cli {
namespace {

constexpr std::size_t kColumns = 80, kOptionColumn = 24;

constexpr const char* kExamples =
    "Robosim runs your Arduino line follower on a simulated robot and judges the run.\n"
    "\n"
    "  robosim run PidFollower --map oval       run a sample sketch on a sample map\n"
    "  robosim run PidFollower --view           watch it drive in the terminal\n"
    "  robosim serve                            choose, run and watch in the browser\n"
    "  robosim run my/Sketch --map my.map       run your own sketch on your own map\n"
    "\n";

/// Counts the characters of UTF-8 text.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Breaks a text into lines between words. Every line except the first begins with `indent` spaces.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const bool fits = column + 1 + width(word) <= kColumns;
    if (!all.empty()) {
      all += fits ? " " : "\n" + std::string(indent, ' ');
      column = fits ? column + 1 : indent;
    }
    all += word;
    column += width(word);
    at = end + 1;
  }
  return all;
}

/// Formats "  --map MAP     text", wrapped.
std::string row(const std::string& name, const std::string& text, std::size_t column) {
  std::string line = "  " + name;
  const std::size_t used = width(line);
  line += used + 2 > column ? "\n" + std::string(column, ' ') : std::string(column - used, ' ');
  return line + wrapped(text, column, column) + "\n";
}

std::string command_lines(const std::vector<CommandHelp>& commands, std::size_t column) {
  std::string text;
  for (const CommandHelp& command : commands)
    text += row(fmt::format("{} {}", command.name, argument_list(command)), command.summary, column);
  return text;
}

std::size_t column_of(const std::vector<CommandHelp>& commands) {
  std::size_t widest = 0;
  for (const CommandHelp& command : commands)
    widest = std::max(widest, width(command.name) + 1 + width(argument_list(command)));
  return widest + 4;
}

std::string grouped(const std::vector<CommandGroup>& groups) {
  std::size_t widest = 0;
  for (const CommandGroup& group : groups)
    for (const CommandHelp& command : group.commands) widest = std::max(widest, width(command.name));
  std::string text;
  for (const CommandGroup& group : groups) {
    text += fmt::format("{}\n", group.title);
    for (const CommandHelp& command : group.commands) text += row(command.name, command.summary, widest + 4);
  }
  return text;
}

std::string option_name(const OptionHelp& option) {
  if (option.meta.empty()) return option.name;
  return fmt::format("{} {}{}", option.name, option.meta, option.is_list ? "..." : "");
}

}  // namespace

std::string argument_list(const CommandHelp& command) {
  if (!command.actions.empty()) return "ACTION";
  std::string text;
  for (const OptionHelp& argument : command.arguments) {
    const std::string name = argument.name + (argument.is_list ? "..." : "");
    text += fmt::format("{}{}", text.empty() ? "" : " ", argument.is_required ? name : "[" + name + "]");
  }
  return text;
}

std::string usage(const CommandHelp& command) {
  const std::string arguments = argument_list(command);
  return fmt::format("robosim {}{}{}{}", command.name, command.actions.empty() ? " [OPTIONS]" : "",
                     arguments.empty() ? "" : " ", arguments);
}

std::string help_text(const CommandHelp& command) {
  std::string text = fmt::format("Usage: {}\n\n{}.\n", usage(command), wrapped(command.summary, 0, 0));
  text[text.find("\n\n") + 2] =
      static_cast<char>(std::toupper(static_cast<unsigned char>(command.summary.at(0))));
  if (!command.details.empty()) text += fmt::format("\n{}\n", wrapped(command.details, 0, 0));
  if (!command.actions.empty()) {
    text += fmt::format("\nActions:\n{}", command_lines(command.actions, column_of(command.actions)));
    return text + fmt::format("\nrobosim help {} ACTION lists the options of an action.\n", command.name);
  }
  if (!command.arguments.empty()) text += "\nArguments:\n";
  for (const OptionHelp& argument : command.arguments)
    text += row(argument.name, argument.what, kOptionColumn);
  text += "\nOptions:\n" + row("-h, --help", kHelpOption, kOptionColumn);
  for (const OptionHelp& option : command.options)
    text += row(option_name(option), option.what, kOptionColumn);
  return text;
}

std::string overview(const std::vector<CommandGroup>& groups) {
  return kExamples + grouped(groups) +
         "\nrobosim help COMMAND explains one command; robosim help says more.\n";
}

std::string full_help(const std::vector<CommandGroup>& groups) {
  std::string text = fmt::format("Usage: robosim COMMAND ...\n\n{}\n{}\n\nOptions\n", grouped(groups),
                                 wrapped(kNamingHelp, 0, 0));
  text += row("-h, --help", "print this help, or that of a command", kOptionColumn);
  text += row("-V, --version", "print the version", kOptionColumn);
  text += "\nExit status\n";
  for (const StatusHelp& status : kStatuses) text += row(status.status, status.meaning, 7);
  return text;
}

}  // namespace robosim::cli
