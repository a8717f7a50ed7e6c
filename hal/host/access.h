// An access to a register in its steps, for those who do not know its value when it begins
// (register_memory.cpp).
#pragma once

#include <stdint.h>

#include "hal/host/registers.h"

namespace robosim {
namespace host {

/// Notes it, at `place` in the sketch, spends its time, serves what is due, and brings all flags up to date.
void begin_access(robosim_register address, int bytes, const void* place);
/// What a read of 1 or 2 bytes then gives.
uint16_t register_value(robosim_register address, int bytes);
/// What a write of 1 or 2 bytes then does.
void set_register(robosim_register address, int bytes, uint16_t value);

}  // namespace host
}  // namespace robosim
