// Explains an access that an address check has rejected. Finds the nearest variable, which the sketch
// probably meant, and the distance of the access from the variable.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/host/image.h"
#include "sim/exec/host/asan_shadow.h"

namespace robosim::exec {

/// Returns a clause for Crash::reason. `stack` is the firmware's stack. Its frames contain texts in which gcc
/// describes the local variables. `shadow` is host::Image::shadow.
std::string explain(const host::BadAccess& access, const std::vector<host::GlobalRecord>& globals,
                    MemoryRange stack, std::uintptr_t shadow);

}  // namespace robosim::exec
