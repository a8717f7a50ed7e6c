// Implements CellDriver (session.h) with the simulated robot that moves from cell to cell (sim/map/cells).
#pragma once

#include <memory>

#include "sim/view/play/session.h"

namespace robosim::play {

/// Makes a driver. The map must outlive the driver, and the start must be on the map's line.
std::unique_ptr<CellDriver> drive_cells(const map::Map& map, const map::Start& start,
                                        double seconds_per_move);

}  // namespace robosim::play
