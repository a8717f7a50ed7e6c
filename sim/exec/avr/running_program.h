// Refers to a firmware image and to the chip that runs it. Exists from power-on to power-off.
#pragma once

#include "sim/exec/avr/diagnosis.h"
#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/machine.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

/// The referenced objects outlive all users of this struct.
struct RunningProgram {
  Machine& machine;
  const Firmware& firmware;
  const DebugInfo& debug;
  const BoardSpec& board;

  Diagnosis diagnosis() const { return {firmware, debug, machine}; }
};

}  // namespace robosim::exec::avr
