#include "sim/cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace robosim::cli {
namespace {

/// Escapes the characters that man(7) would interpret: backslashes, hyphens, and a period or an apostrophe at
/// the beginning.
std::string roff(const std::string& text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (safe.empty() && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '\\') safe += "\\e";
    if (c == '-') safe += "\\-";
    if (c != '\\' && c != '-') safe += c;
  }
  return safe;
}

std::string title(const std::string& page) {
  std::string capitals = page;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return fmt::format(".TH {} 1 \"\" \"Robosim {}\" \"Robosim\"\n", roff(capitals), ROBOSIM_VERSION);
}

std::string item(const std::string& name, const std::string& meta, const std::string& text) {
  return fmt::format(".TP\n\\fB{}\\fR{}{}\n{}\n", roff(name), meta.empty() ? "" : " ",
                     meta.empty() ? "" : "\\fI" + roff(meta) + "\\fR", roff(text));
}

std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string statuses() {
  std::string text = ".SH EXIT STATUS\n";
  for (const StatusHelp& status : kStatuses) text += item(status.status, "", status.meaning);
  return text;
}

std::string parameters(const CommandHelp& command, const char* arguments, const char* options) {
  std::string text;
  if (!command.arguments.empty()) text += arguments;
  for (const OptionHelp& argument : command.arguments) text += item(argument.name, "", argument.what);
  text += options + item("-h, --help", "", kHelpOption);
  for (const OptionHelp& option : command.options)
    text += item(option.name, option.meta + (option.is_list ? "..." : ""), option.what);
  return text;
}

std::string synopsis(const CommandHelp& command) {
  return fmt::format(".B robosim {}\n{}{}\n", roff(command.name),
                     command.actions.empty() ? "[\\fIOPTIONS\\fR] " : "", roff(argument_list(command)));
}

}  // namespace

std::string man_page(const std::vector<CommandGroup>& groups) {
  std::string text =
      title("robosim") +
      ".SH NAME\nrobosim \\- run Arduino line followers on simulated robots and judge the runs\n"
      ".SH SYNOPSIS\n.B robosim\n\\fICOMMAND\\fR ...\n.SH DESCRIPTION\n" +
      roff(
          "Robosim takes an Arduino sketch as it is, and drives a simulated robot with it. The floor is "
          "drawn as text. Robosim judges the run.") +
      "\n.PP\n" + roff(kNamingHelp) + "\n.SH COMMANDS\n";
  std::string pages;
  for (const CommandGroup& group : groups) {
    text += fmt::format(".SS {}\n", roff(group.title));
    for (const CommandHelp& command : group.commands) {
      text += item(command.name, argument_list(command), sentence(command.summary));
      pages += fmt::format("{}.BR robosim\\-{} (1)", pages.empty() ? "" : ",\n", command.name);
    }
  }
  return text + ".SH OPTIONS\n" + item("-h, --help", "", "print the commands, or the help of a command") +
         item("-V, --version", "", "print the version") + statuses() + ".SH SEE ALSO\n" + pages + "\n";
}

std::string man_page(const CommandHelp& command) {
  std::string text =
      title("robosim-" + command.name) +
      fmt::format(".SH NAME\nrobosim\\-{} \\- {}\n.SH SYNOPSIS\n", command.name, roff(command.summary));
  if (command.actions.empty()) text += synopsis(command);
  for (const CommandHelp& action : command.actions) text += synopsis(action) + ".br\n";
  text += fmt::format(".SH DESCRIPTION\n{}\n", roff(sentence(command.summary)));
  if (!command.details.empty()) text += fmt::format(".PP\n{}\n", roff(command.details));
  for (const CommandHelp& action : command.actions) {
    text += fmt::format(".SH {}\n{}\n", roff(action.name), roff(sentence(action.summary)));
    if (!action.details.empty()) text += fmt::format(".PP\n{}\n", roff(action.details));
    text += parameters(action, "", "");
  }
  if (command.actions.empty()) text += parameters(command, ".SH ARGUMENTS\n", ".SH OPTIONS\n");
  return text + statuses() + ".SH SEE ALSO\n.BR robosim (1)\n";
}

}  // namespace robosim::cli
