// Finds the wiring that a sketch used, and the wiring that it never used. A sketch that seems to do nothing
// usually drives a pin other than the wired one.
#pragma once

#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_probe.h"
#include "sim/result/run_result.h"
#include "sim/robot/robot.h"

namespace robosim::judge {

/// Returns unwired pins that were used, parts that were not used, and parts whose reading hardly changed.
/// `was_output` states for each pin of the board whether the firmware ever drove the pin. `now` is the end of
/// the run. If a part was last read a second or more before, its reading includes the time of this read.
///
/// A read of a port register reads eight pins, and does not show which pin the firmware needs. An unwired pin
/// therefore counts as read only in three cases: it was read singly, was measured by the ADC, or was read
/// with its pull-up on. A part counts as used if any of its pins may have been read. Parts on a shift
/// register, or on the pins of the UART, count as used.
result::Usage usage_of(const BoardSpec& board, const std::vector<robot::WiredPin>& wiring,
                       const std::vector<bool>& was_output, const exec::BoardProbe& probe, SimTime now);

}  // namespace robosim::judge
