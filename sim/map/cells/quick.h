// Makes many moves at once if no watcher follows each move. The robot's place, direction and moves are then
// in processor registers. The byte of the robot's cell decides the next move. If the byte is not sufficient,
// these functions stop, and the caller makes the next move with CellRobot.
#pragma once

#include <cstdint>

#include "sim/map/cells/cell_floor.h"

namespace robosim::cells {

/// The side to which a walk keeps, as in wall following.
enum class Side { left, right };

/// Moves along plain line. In a plain cell, line continues on exactly two sides, of which one is behind the
/// robot. No neighbour of the cell has an obstacle. Moves `spot` to the first cell that is not plain, or by
/// `most` cells. Returns the number of moves.
std::uint64_t run_along(const CellFloor& floor, Spot& spot, std::uint64_t most);

/// Makes at most `most` moves of the walk that keeps to `side`. Returns the number of moves.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most);
/// Walks like the function above, but also stops where a line may end, and at the spots `a` and `b`.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most, const Spot& a,
                      const Spot& b);

}  // namespace robosim::cells
