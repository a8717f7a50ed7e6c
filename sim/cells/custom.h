// A user's own algorithm, from a shared object that exports navigate() (include/robosim/cells.h).
#pragma once

#include <filesystem>

#include "sim/cells/walk.h"

namespace robosim::cells {

/// Runs it until it returns or the robot's moves are used up. Whatever the algorithm does to its process it
/// does to the caller's: call this in a separate process. Throws InputError if the file has no navigate();
/// passes on what the algorithm throws.
Walk run_custom(CellRobot& robot, const std::filesystem::path& shared_object);

}  // namespace robosim::cells
