// Options of `run` and `compare` for one of several robots. `--robot A=uno5` applies to robot A.
// `--robot uno5` applies to all robots without a value of their own. The sketch argument may also name a
// fleet file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/cli/options.h"
#include "sim/launch/run_settings.h"

namespace robosim::cli {

/// A value for all robots, or for one robot, as in "A=uno5". A path may contain = after its first '/' or '.'.
struct Named {
  std::string name;  ///< empty = for all
  std::string value;
};
Named named(const std::string& word);

class FleetOptions {
 public:
  /// Adds the options. If `compares` is true, the command handles --target itself.
  FleetOptions(Options& options, launch::RunSettings& run, bool compares = false);
  /// Distributes the given values to the robots. Call it after options.parse(). Throws InputError.
  void finish();
  /// Throws InputError if no robot has this name.
  void check_known(const char* option, const std::string& name);

 private:
  /// An option, and the destination of its value.
  struct Given {
    const char* option;  ///< empty = the sketch
    std::string& (*of)(launch::Launch&);
    std::vector<std::string> values = {};
  };
  void read_file();
  void take(const Given& given);
  void take_scripts();
  launch::Member& member(const char* option, const std::string& name);

  launch::RunSettings& run_;
  const char* command_;
  std::vector<std::string> scripts_;
  std::array<Given, 5> given_;
};

}  // namespace robosim::cli
