// Reports the preparation of a run (sim/launch) on standard error.
#pragma once

#include "sim/launch/launch.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {

/// Selects the reports that are printed to standard error.
struct Says {
  bool choices = true;        ///< automatic choices
  bool warnings = true;       ///< warnings of the compiler
  bool all_warnings = false;  ///< all of these warnings, instead of the first 20 lines
};
launch::Listener listener_of(terminal::Progress& progress, Says says = {});

}  // namespace robosim::cli
