// Reasons to compile a program once more, with other settings.
#pragma once

#include <exception>

#include "sim/build/toolchain.h"

namespace robosim::build {

/// The program does not compile with its present registers, but may with these.
struct RetryReason {
  Registers with;
  std::exception_ptr otherwise = nullptr;  ///< the error to report if they do not help; null = the second one
  bool narrow_ints = false;                ///< the sketch needs an int of 16 bits
};

// Marks in a program's assembly if it stores a register's address (hal/host/registers.h). Also a mark in a
// compiler's message about a use of a register that its class does not support (hal/arduino/avr/io.h).
inline constexpr const char* kRegisterMemory = "robosim_register_memory";
inline constexpr const char* kRegisterClass = "robosim_hal::Register";

}  // namespace robosim::build
