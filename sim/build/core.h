// The Arduino core of a target, compiled: for the host hal/host, hal/arduino and the genuine core's portable
// sources as one object file, for a chip the genuine core as an archive.
#pragma once

#include <filesystem>

#include "sim/build/cache.h"
#include "sim/build/compile.h"

namespace robosim::build {

/// Compiled once for each version of Robosim and of the compiler. In the host's object hal/host comes first:
/// its constructors (Serial's) run before any of the sketch's. All of it is weak, so that a sketch may
/// redefine a function of the core, as Arduino's archive of the core allows.
Object core_object(const Toolchain& toolchain, const Cache& cache, WorkFolder& work);

}  // namespace robosim::build
