// Connects the robot on cells (sim/cells) to a session (sim/tui).
#pragma once

#include <memory>

#include "sim/play/session.h"

namespace robosim::play {

/// The map must outlive the driver, and the start must be on its line.
std::unique_ptr<CellDriver> drive_cells(const grid::Map& map, const grid::Start& start,
                                        double seconds_per_move);

}  // namespace robosim::play
