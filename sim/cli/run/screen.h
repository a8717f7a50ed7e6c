// What the screens at the end of runs have room for.
#pragma once

#include <filesystem>
#include <memory>

#include "sim/cli/arguments.h"
#include "sim/grid/map.h"
#include "sim/tui/frame.h"

namespace robosim::cli {

/// The standard output's width, as far as it is used, and how it shows things.
struct ScreenSize {
  int columns;
  tui::Look look;
};
ScreenSize screen_size();

/// Throws InputError where --view has no terminal.
void check_view(const RunArguments& arguments);

/// The map for pictures; null if it is too large for one.
std::unique_ptr<grid::Map> map_to_draw(const std::filesystem::path& path);

}  // namespace robosim::cli
