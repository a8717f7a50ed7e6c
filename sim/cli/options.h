// The options of one command, and values that several commands read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/option_values.h"
#include "sim/cli/help.h"

namespace robosim::cli {

/// Reads all options as text. The commands check the values afterwards, so that messages are uniform.
class Options {
 public:
  /// Sets the command's name, `summary` and `details` (see CommandHelp).
  Options(const std::string& command, const std::string& summary, const std::string& details = "");

  /// Adds a positional argument. `name` is written as in the usage: "MAP" if required, "[MAP]" if optional.
  void positional(const std::string& name, std::string& value, const char* what, PossibleValues values = {});
  void positionals(const std::string& name, std::vector<std::string>& values, const char* what,
                   PossibleValues possible = {});
  void text(const char* name, std::string& value, const char* meta, const char* what,
            PossibleValues values = {});
  /// Adds an option that may be repeated.
  void texts(const char* name, std::vector<std::string>& values, const char* meta, const char* what,
             PossibleValues possible = {});
  /// Adds an option that may be repeated, with several words each time.
  void lists(const char* name, std::vector<std::string>& values, const char* meta, const char* what,
             PossibleValues possible = {});
  void flag(const char* name, bool& value, const char* what);

  /// Parses the words into the values. If the user requested the help, returns the help. Throws InputError.
  std::optional<PrintText> parse(std::vector<std::string> words);

 private:
  /// The destination of an option's value.
  struct Taker {
    std::string* one = nullptr;
    std::vector<std::string>* several = nullptr;
    bool* flag = nullptr;
  };
  void add_positional(const std::string& name, Taker taker, const char* what, PossibleValues values);
  void add_option(OptionHelp help, Taker taker);
  [[noreturn]] void refuse(const std::string& word) const;
  [[noreturn]] void refuse_missing_value(const std::string& option) const;

  CommandHelp help_;
  std::vector<Taker> arguments_, options_;  ///< in the order of help_.arguments and help_.options
};

// Explanations of options that many commands have.
constexpr const char* kProfileHelp =
    "simulate ideal hardware (no noise), or typical hardware as estimated (typical@1, the default) or as "
    "measured (typical@2)";
constexpr const char* kEnvironmentHelp =
    "use this environment of platformio.ini, or this profile of sketch.yaml";
constexpr const char* kUntrustedHelp =
    "treat the sketch as hostile: run it only if this machine can confine it";
constexpr const char* kLibrariesHelp = "use the Arduino libraries in this folder; may be repeated";
constexpr const char* kSketchHelp =
    "use this sketch: a folder, an .ino file or the name of a sample sketch (default: the current folder)";
constexpr const char* kMapHelp = "use this map: a file, or the name of a sample map";
constexpr const char* kJobsHelp = "do this many runs at a time (default: one for each core)";
constexpr const char* kShardHelp = "do only the I-th of N parts of the runs; --merge combines the parts";

// Return the possible values of options that many commands have, for completion.
PossibleValues targets();
PossibleValues profiles();
PossibleValues goals();

}  // namespace robosim::cli
