// What of the wiring a sketch used, and what it never did: most sketches that do nothing drive another pin
// than the one that the robot is wired to.
#pragma once

#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_probe.h"
#include "sim/robot/robot.h"
#include "sim/wire/run_result.h"

namespace robosim::judge {

/// `was_output`: per pin of the board, whether the firmware ever drove it.
///
/// A read of a port reads eight pins, and who meant which of them is mostly not known. So a pin to which
/// nothing is wired counts as read only where it was looked at, measured, or had its pull-up on; and a part
/// counts as used if any of its pins may have been read. What hangs on a shift register, or on the pins of
/// the UART, is taken for used.
wire::Usage usage_of(const BoardSpec& board, const std::vector<robot::WiredPin>& wiring,
                     const std::vector<bool>& was_output, const exec::BoardProbe& probe);

}  // namespace robosim::judge
