// Registers in memory, for libraries that keep their addresses: `volatile uint8_t* port =
// portOutputRegister(…)`.
//
// An image in which somebody does so is compiled with ROBOSIM_REGISTER_MEMORY (sim/build/target.cpp): there a
// register is a byte of robosim_register_memory, at its address in the chip's data space, and gcc calls us
// before each access to memory that is not a function's own (-fsanitize=thread, without its library). Before
// a read the byte gets what the register holds. What is written is known only after the access: it is settled
// before the next one, the next call and the next basic block, as of the moment of the write.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Settles the register that was written last; null = that is done. A pointer, so that images without such
/// registers have none of this.
extern void (*unsettled)();

inline void settle_registers() {
  if (__builtin_expect(unsettled != nullptr, 0)) unsettled();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
