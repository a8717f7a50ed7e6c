// Compiles the Arduino core of a target. For the host it is one object file of hal/host, hal/arduino and the
// genuine core's portable sources. For a chip it is an archive of the genuine core.
#pragma once

#include <filesystem>

#include "sim/build/cache.h"
#include "sim/build/compile.h"

namespace robosim::build {

/// Compiled once for each version of Robosim and of the compiler. In the host's object hal/host comes first:
/// its constructors (Serial's) run before the sketch's. All symbols are weak. So a sketch may redefine a
/// function of the core, as Arduino's archive of the core allows.
Object core_object(const Toolchain& toolchain, const Cache& cache, WorkFolder& work);

}  // namespace robosim::build
