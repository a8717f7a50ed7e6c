// Describes why a program is compiled again with other settings.
#pragma once

#include <exception>

#include "sim/build/toolchain.h"

namespace robosim::build {

/// Thrown if the program does not compile with the present settings, but may compile with other settings.
struct RetryReason {
  Registers with;
  std::exception_ptr otherwise = nullptr;  ///< error to report if the retry fails; null = the retry's error
  bool narrow_ints = false;                ///< the sketch needs 16-bit ints
};

// kRegisterMemory marks assembly that stores a register's address (hal/host/registers.h). kRegisterClass
// marks a compiler's message about a use of a register that its class does not support
// (hal/arduino/avr/io.h).
inline constexpr const char* kRegisterMemory = "robosim_register_memory";
inline constexpr const char* kRegisterClass = "robosim_hal::Register";

}  // namespace robosim::build
