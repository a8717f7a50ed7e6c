// What the screens at the end of runs have room for.
#pragma once

#include <memory>

#include "sim/cli/arguments.h"
#include "sim/grid/map.h"
#include "sim/tui/frame.h"
#include "sim/wire/run_request.h"

namespace robosim::cli {

/// The standard output's width, as far as it is used, and how it shows things.
struct ScreenSize {
  int columns;
  tui::Look look;
};
ScreenSize screen_size();

/// Throws InputError where --view has no terminal.
void check_view(const RunArguments& arguments);

/// The map of a run, as its seed draws it.
grid::Map map_of(const wire::RunRequest& request);
/// The same for pictures; null if it is too large for one.
std::unique_ptr<grid::Map> map_to_draw(const wire::RunRequest& request);

}  // namespace robosim::cli
