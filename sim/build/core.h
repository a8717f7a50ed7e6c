// Compiles the Arduino core of a target. For the host, the core is one object file of hal/host, hal/arduino
// and the genuine core's portable sources. For an STM32, the core is an archive that contains hal/stm32
// instead of hal/host. For an AVR, it is an archive of the genuine core and hal/avr.
#pragma once

#include <filesystem>

#include "sim/build/cache.h"
#include "sim/build/compile.h"

namespace robosim::build {

/// Returns the core, which is compiled once for each version of Robosim and of the compiler. In the host's
/// object, hal/host comes first: its constructors, such as Serial's, must run before the sketch's
/// constructors. All symbols of this object are weak, so that a sketch may redefine a function of the core.
/// Arduino's archive of the core allows that, too.
Object core_object(const Toolchain& toolchain, const Cache& cache, WorkFolder& work);

/// Replaces the names of the core's objects in a linker's messages by those of their sources: "core10.o:"
/// becomes "core/Tone.cpp:".
std::string with_names_of_core(const Toolchain& toolchain, const std::string& messages);

}  // namespace robosim::build
