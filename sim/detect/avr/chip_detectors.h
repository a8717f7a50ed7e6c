// Creates all detectors that observe the flashed sketch on an AVR.
#pragma once

#include <memory>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/avr/running_program.h"
#include "sim/exec/core/detector.h"

namespace robosim::detect::avr {

/// Creates the detectors for a chip that is about to start. `counted` lists the pins on which every edge
/// matters, such as the pins of an encoder.
std::vector<std::unique_ptr<exec::Detector>> chip_detectors(const exec::avr::RunningProgram& program,
                                                            const std::vector<Pin>& counted);

}  // namespace robosim::detect::avr
