// Runs a user's algorithm, from a shared object that exports navigate() (include/robosim/cells.h).
#pragma once

#include <filesystem>

#include "sim/map/cells/walk.h"

namespace robosim::cells {

/// Runs the algorithm until it returns or the robot's moves are used up. The algorithm runs in the caller's
/// process and can damage it: call this function in a separate process. Throws InputError if the file has no
/// navigate(). Passes on the exceptions of the algorithm.
Walk run_custom(CellRobot& robot, const std::filesystem::path& shared_object);

}  // namespace robosim::cells
