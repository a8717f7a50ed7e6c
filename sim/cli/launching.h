// From a command line to a launch, what is said on standard error while it is prepared, and what recordings
// say of it.
#pragma once

#include <string>

#include "sim/cli/arguments.h"
#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"
#include "sim/record/recorder.h"
#include "sim/tui/progress.h"

namespace robosim::cli {

/// Of one file. Throws InputError.
std::string script_text(const std::string& file);

/// The scenario's text: the file of --script, then a line for each --send. Throws InputError.
std::string scenario_text(const RunArguments& arguments);

/// With that scenario.
launch::Launch launch_of(const RunArguments& arguments);

/// What is said on standard error.
struct Says {
  bool choices = true;   ///< made for the user
  bool warnings = true;  ///< of the compiler
};
launch::Listener listener_of(tui::Progress& progress, Says says = {});

/// What recordings say of a run. `version`: the runner's.
record::RecordedRun recorded(const launch::Prepared& run, const std::string& version);
record::RecordedRun recorded(const launch::Fleet& fleet, const launch::PreparedFleet& run,
                             const std::string& version);

}  // namespace robosim::cli
