// Divides a register access into steps. This is for code that knows the value to write only after the access
// has begun (register_memory.cpp).
#pragma once

#include <stdint.h>

#include "hal/host/registers.h"

namespace robosim {
namespace host {

/// Begins an access by the code at the address `place`. Records the access, spends its time, serves due
/// interrupts, and updates all flags.
void begin_access(robosim_register address, int bytes, const void* place);
/// Returns the value that a read of 1 or 2 bytes yields. Call it after begin_access().
uint16_t register_value(robosim_register address, int bytes);
/// Carries out a write of 1 or 2 bytes. Call it after begin_access().
void set_register(robosim_register address, int bytes, uint16_t value);

}  // namespace host
}  // namespace robosim
