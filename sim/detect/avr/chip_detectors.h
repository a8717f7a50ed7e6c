// Makes all detectors of an AVR.
#pragma once

#include <memory>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/avr/running_program.h"
#include "sim/exec/core/detector.h"

namespace robosim::detect::avr {

/// Makes the detectors for a chip that is about to start. `counted`: pins on which every edge matters.
std::vector<std::unique_ptr<exec::Detector>> chip_detectors(const exec::avr::RunningProgram& program,
                                                            const std::vector<Pin>& counted);

}  // namespace robosim::detect::avr
