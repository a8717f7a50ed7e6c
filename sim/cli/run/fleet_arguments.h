// Options of `run` that may be of one robot of several: `--robot A=uno5` is robot A's, `--robot uno5` that of
// all who have none of their own. A word in the place of the sketch may also name a fleet's file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/cli/options.h"

namespace robosim::cli {

/// What a robot of the fleet has none of is that of all.
void fill_up(launch::Fleet& fleet, const RunArguments& all);

class FleetOptions {
 public:
  FleetOptions(Options& options, RunArguments& run);
  /// After options.parse(): hands out what was given. Throws InputError.
  void finish();

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
  std::vector<std::string> scripts_;
  std::array<Given, 5> given_;
};

}  // namespace robosim::cli
