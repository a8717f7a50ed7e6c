// Provides the target avr for runner programs: executors for emulated AVR chips, with the detectors for them.
#pragma once

#include "sim/detect/avr/chip_detectors.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/runner/session.h"

namespace robosim::runner {

inline ExecutorFactory avr_target() {
  return {"avr", [](const BoardSpec& board, const std::filesystem::path& image) {
            return std::make_unique<exec::AvrExecutor>(board, image, detect::avr::chip_detectors);
          }};
}

}  // namespace robosim::runner
