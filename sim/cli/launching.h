// Converts a command line to a launch, reports its preparation on standard error, and describes it in
// recordings.
#pragma once

#include <string>

#include "sim/cli/arguments.h"
#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"
#include "sim/record/recorder.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {

/// Reads a script file. Throws InputError.
std::string script_text(const std::string& file);

/// Returns the scenario's text: the file of --script, then a line for each --send. Throws InputError.
std::string scenario_text(const RunArguments& arguments);

/// Returns the launch, with its scenario.
launch::Launch launch_of(const RunArguments& arguments);

/// Selects the reports on standard error.
struct Says {
  bool choices = true;   ///< automatic choices
  bool warnings = true;  ///< warnings of the compiler
};
launch::Listener listener_of(terminal::Progress& progress, Says says = {});

/// Returns the description of a run for recordings. `version`: the runner's version.
record::RecordedRun recorded(const launch::Prepared& run, const std::string& version);
record::RecordedRun recorded(const launch::Fleet& fleet, const launch::PreparedFleet& run,
                             const std::string& version);

}  // namespace robosim::cli
