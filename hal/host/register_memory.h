// Implements registers as bytes of memory, for libraries that store addresses of registers: `volatile
// uint8_t* port = portOutputRegister(…)`.
//
// An image with such code is compiled with ROBOSIM_REGISTER_MEMORY (sim/build/target.cpp). A register is then
// a byte of robosim_register_memory; the index is the register's address in the chip's data space. With the
// option -fsanitize=thread, gcc inserts calls of functions in register_memory.cpp before accesses to
// non-local memory. gcc's library for these calls is not used.
//
// Before a read, the register's value is copied to the byte. Before a write, the value is not yet known. The
// write takes effect before the next access, API call or basic block, but with the time of the write.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// The function that must run before the next access, API call or basic block: it applies a pending write, or
/// interrupts a look (polling.h). Null if there is nothing to do. Because this is a pointer, images without
/// registers in memory do not contain the code.
extern void (*unsettled)();

inline void settle_registers() {
  if (__builtin_expect(unsettled != nullptr, 0)) unsettled();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
