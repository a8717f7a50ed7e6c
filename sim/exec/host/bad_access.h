// Explains an access that an address check has rejected. Finds the variable that was probably meant, and how
// far outside the variable the access was.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/host/image.h"
#include "sim/exec/host/asan_shadow.h"

namespace robosim::exec {

/// Returns a clause for Crash::reason. `stack` is the firmware's stack, whose frames contain gcc's texts
/// about local variables. `shadow` is host::Image::shadow.
std::string explain(const host::BadAccess& access, const std::vector<host::GlobalRecord>& globals,
                    MemoryRange stack, std::uintptr_t shadow);

}  // namespace robosim::exec
