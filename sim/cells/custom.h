// An algorithm of the user's own, from a shared object that exports navigate() (include/robosim/cells.h).
#pragma once

#include <filesystem>

#include "sim/cells/walk.h"

namespace robosim::cells {

/// Runs it until it returns or the robot's moves are used up. Whatever the algorithm does to its process it
/// does to the caller's: call this in a process of its own. Throws InputError if the file has no navigate();
/// what the algorithm throws goes through.
Walk run_custom(CellRobot& robot, const std::filesystem::path& shared_object);

}  // namespace robosim::cells
