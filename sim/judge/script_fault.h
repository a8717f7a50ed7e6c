// Defines a fault that a script has injected. The explanation of a verdict names such a fault as a cause.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/robot/fault.h"

namespace robosim::judge {

struct ScriptFault {
  std::string part;                       ///< a part of the robot, or power, serial, eeprom, clock
  std::vector<std::string> arguments;     ///< the kind of fault, then its arguments: {"stuck", "1023"}
  std::optional<robot::Failure> failure;  ///< kind of a part's fault; unset for a fault of the board
  SimTime began = 0;
  SimTime ended = kNever;  ///< when the fault was repaired, or replaced by another fault of the same part
};

}  // namespace robosim::judge
