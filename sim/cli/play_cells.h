// The robot on cells (sim/classic), as a session drives it (sim/view).
#pragma once

#include <memory>

#include "sim/view/session.h"

namespace robosim::cli {

/// The map must outlive the driver, and the start be on its line.
std::unique_ptr<view::CellDriver> drive_cells(const grid::Map& map, const grid::Start& start,
                                              double seconds_per_move);

}  // namespace robosim::cli
