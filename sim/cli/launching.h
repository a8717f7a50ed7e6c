// From a command line to a launch, and what is said on standard error while it is prepared.
#pragma once

#include <string>

#include "sim/cli/arguments.h"
#include "sim/launch/launch.h"
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

}  // namespace robosim::cli
