// Prepares the screen that is printed at the end of a run: its size, and the map on it.
#pragma once

#include <memory>

#include "sim/cli/arguments.h"
#include "sim/map/map.h"
#include "sim/view/terminal/frame.h"
#include "sim/wire/run_request.h"

namespace robosim::cli {

/// The standard output's usable width, and its display options.
struct ScreenSize {
  int columns;
  terminal::Look look;
};
ScreenSize screen_size();

/// Throws InputError if --view is given, but the standard output is not a terminal.
void check_view(const RunArguments& arguments);

/// Returns the map of a run. Random values of the map depend on the run's seed and profile.
map::Map map_of(const wire::RunRequest& request);
/// Returns the map for pictures; null if it is too large to draw.
std::unique_ptr<map::Map> map_to_draw(const wire::RunRequest& request);

}  // namespace robosim::cli
