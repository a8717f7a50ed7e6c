// The steps of a register access, for code that learns the written value only after the access begins
// (register_memory.cpp).
#pragma once

#include <stdint.h>

#include "hal/host/registers.h"

namespace robosim {
namespace host {

/// Records the access at `place` in the sketch, spends its time, serves due work, and updates all flags.
void begin_access(robosim_register address, int bytes, const void* place);
/// Returns the value that a read of 1 or 2 bytes yields. Call it after begin_access().
uint16_t register_value(robosim_register address, int bytes);
/// Carries out a write of 1 or 2 bytes. Call it after begin_access().
void set_register(robosim_register address, int bytes, uint16_t value);

}  // namespace host
}  // namespace robosim
