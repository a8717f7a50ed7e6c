// Registers in memory, for libraries that store their addresses: `volatile uint8_t* port =
// portOutputRegister(…)`.
//
// An image with such code is compiled with ROBOSIM_REGISTER_MEMORY (sim/build/target.cpp). A register is then
// a byte of robosim_register_memory, at its address in the chip's data space. gcc inserts calls of functions
// in register_memory.cpp before accesses to non-local memory (-fsanitize=thread, without its library).
//
// Before a read, the register's value is copied to the byte. A written value is known only after the access.
// It takes effect before the next access, call or basic block, but with the time of the write.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Applies the register that was written last; null if no write is pending. It is a pointer, so that images
/// without such registers do not contain the code.
extern void (*unsettled)();

inline void settle_registers() {
  if (__builtin_expect(unsettled != nullptr, 0)) unsettled();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
