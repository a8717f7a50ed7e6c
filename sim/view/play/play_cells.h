// Connects the robot on cells (sim/map/cells) to a session (sim/view/terminal).
#pragma once

#include <memory>

#include "sim/view/play/session.h"

namespace robosim::play {

/// The map must outlive the driver, and the start must be on its line.
std::unique_ptr<CellDriver> drive_cells(const map::Map& map, const map::Start& start,
                                        double seconds_per_move);

}  // namespace robosim::play
