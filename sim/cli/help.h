// Names, meanings and values of commands, arguments and options: the single source of help texts, manual
// pages and shell completion.
#pragma once

#include <string>
#include <vector>

namespace robosim::cli {

/// Describes the possible values of an argument or option, for completion.
struct PossibleValues {
  enum class Kind { any, words, file, folder, sketch, map, robot };
  Kind kind = Kind::any;
  std::vector<std::string> words = {};  ///< all possible values of Kind::words

  static PossibleValues of(std::vector<std::string> words) { return {Kind::words, std::move(words)}; }
  static PossibleValues file() { return {Kind::file}; }
  static PossibleValues folder() { return {Kind::folder}; }
  static PossibleValues sketch() {
    return {Kind::sketch};
  }                                                    ///< a folder, a file or the name of a sample sketch
  static PossibleValues map() { return {Kind::map}; }  ///< a file or the name of a sample map
  static PossibleValues robot() { return {Kind::robot}; }  ///< a file or the name of a stock robot
};

/// Describes one argument or option.
struct OptionHelp {
  std::string name;  ///< "--map" for an option, "MAP" for an argument
  std::string meta;  ///< placeholder of the value, "MAP"; empty = a flag
  std::string what;
  PossibleValues values;
  bool is_list = false;      ///< accepts any number of words
  bool is_required = false;  ///< for an argument
};

/// Describes one command, or one action of a command: "map", "map check".
struct CommandHelp {
  std::string name;
  std::string summary;  ///< imperative, one line, no full stop
  std::string details;  ///< sentences; empty = none
  std::vector<OptionHelp> arguments, options;
  std::vector<CommandHelp> actions;
};

/// The commands for one task, under a heading of the overview.
struct CommandGroup {
  std::string title;
  std::vector<CommandHelp> commands;
};

/// A text to print instead of running a command. For a command's help, also contains its structured form.
struct PrintText {
  std::string text;
  CommandHelp help = {};
};

inline constexpr const char* kHelpOption = "print this help";

/// One row of the table of exit statuses.
struct StatusHelp {
  const char* status;
  const char* meaning;
};
inline constexpr StatusHelp kStatuses[] = {
    {"0", "the goal was reached, or the check holds"},
    {"1", "lost, stuck, toppled, hung, ended, crashed, over budget, or a difference was found"},
    {"2", "wrong usage, a bad file, or a sketch that does not compile"},
    {"3", "an internal error of Robosim"},
    {"4", "the simulated time was up"},
    {"5", "a tool is missing; its Debian package is printed"},
    {"130", "interrupted by Ctrl-C"}};

/// Explains how sketches, maps and robots are named.
inline constexpr const char* kNamingHelp =
    "SKETCH is a folder, an .ino file or the name of a sample sketch (default: the current folder). A name "
    "with / or . is a path.";

/// Returns a command's usage line, such as "robosim run [OPTIONS] [SKETCH...]".
std::string usage(const CommandHelp& command);
/// Returns the arguments that follow a command's name in the overview, such as "[SKETCH]".
std::string argument_list(const CommandHelp& command);

/// Returns the output of `robosim COMMAND --help`.
std::string help_text(const CommandHelp& command);
/// Returns the output of a bare `robosim`: examples, then the commands by task.
std::string overview(const std::vector<CommandGroup>& groups);
/// Returns the output of `robosim --help`: the commands by task, then names and exit statuses.
std::string full_help(const std::vector<CommandGroup>& groups);

}  // namespace robosim::cli
