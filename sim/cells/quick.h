// Many moves at once, for where nobody asks after each of them: the robot's place, direction and moves are
// then kept in registers, and a cell's byte decides alone. Where the byte does not decide, these stop, and
// the caller goes on with a move of CellRobot's own.
#pragma once

#include <cstdint>

#include "sim/cells/cell_floor.h"

namespace robosim::cells {

/// For the walk that keeps to one side of the line.
enum class Side { left, right };

/// Along plain line: over cells that have line on two sides, one of them behind, and no obstacle beside.
/// Moves `spot` to the first cell that is not plain, or by `most` cells. Returns the number of moves.
std::uint64_t run_along(const CellFloor& floor, Spot& spot, std::uint64_t most);

/// The walk that keeps to a side, by at most `most` moves. Returns their number.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most);
/// The same, which stops where a line may end, and when it has come to one of two spots.
std::uint64_t keep_to(Side side, const CellFloor& floor, Spot& spot, std::uint64_t most, const Spot& a,
                      const Spot& b);

}  // namespace robosim::cells
