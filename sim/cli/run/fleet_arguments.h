// Options of `run` and `compare` that may be of one robot of several: `--robot A=uno5` is robot A's, `--robot
// uno5` that of all who have none of their own. A word in the place of the sketch may also name a fleet's
// file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/cli/options.h"

namespace robosim::cli {

/// What a robot of the fleet has none of is that of all.
void fill_up(launch::Fleet& fleet, const RunArguments& all);

/// "A=uno5" is of A; a path may have = in it behind its first '/' or '.'.
struct Named {
  std::string name;  ///< empty = of all
  std::string value;
};
Named named(const std::string& word);

class FleetOptions {
 public:
  /// `compares`: its --target is the command's own.
  FleetOptions(Options& options, RunArguments& run, bool compares = false);
  /// After options.parse(): hands out what was given. Throws InputError.
  void finish();
  /// Throws InputError if no robot has this name.
  void check_known(const char* option, const std::string& name);

 private:
  /// One option, and where its value goes.
  struct Given {
    const char* option;  ///< empty = the sketch
    std::string& (*of)(launch::Launch&);
    std::vector<std::string> values = {};
  };
  void read_file();
  void take(const Given& given);
  void take_scripts();
  launch::Member& member(const char* option, const std::string& name);

  RunArguments& run_;
  const char* command_;
  std::vector<std::string> scripts_;
  std::array<Given, 5> given_;
};

}  // namespace robosim::cli
