// Why a program is compiled once more, with something taken otherwise.
#pragma once

#include <exception>

#include "sim/build/toolchain.h"

namespace robosim::build {

/// The program does not compile with its registers as they are, but may with these.
struct TryAgain {
  Registers with;
  std::exception_ptr otherwise = nullptr;  ///< the error to report if they do not help; null = theirs
  bool narrow_ints = false;                ///< the sketch needs an int of 16 bits
};

// What assembly of a program holds that keeps a register's address (hal/host/registers.h), and a compiler's
// message about one that does more with a register than its class can (hal/arduino/avr/io.h).
inline constexpr const char* kRegisterMemory = "robosim_register_memory";
inline constexpr const char* kRegisterClass = "robosim_hal::Register";

}  // namespace robosim::build
