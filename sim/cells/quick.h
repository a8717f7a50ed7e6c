// Makes many moves at once if no watcher follows each move. The robot's place, direction and moves are then
// in registers, and a cell's byte alone decides. If the byte does not decide, these functions stop, and the
// caller continues with a move of CellRobot.
#pragma once

#include <cstdint>

#include "sim/cells/cell_floor.h"

namespace robosim::cells {

/// The side on which a wall-following walk keeps the line.
enum class Side { left, right };

/// Moves along plain line: over cells that have line on two sides, one of them behind the robot, and no
/// neighbouring obstacle. Moves `spot` to the first cell that is not plain, or by `most` cells. Returns the
/// number of moves.
std::uint64_t run_along(const CellFloor& floor, Spot& spot, std::uint64_t most);

/// Walks along one side, by at most `most` moves. Returns the number of moves.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most);
/// Walks like the function above, but also stops where a line may end, and at the spots `a` and `b`.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most, const Spot& a,
                      const Spot& b);

}  // namespace robosim::cells
