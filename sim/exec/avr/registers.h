// Names of registers inside the emulated chip, and the registers that calls use.
#pragma once

#include "hal/board/avr_registers.h"
#include "hal/board/chip_spec.h"

namespace robosim::exec::avr {

namespace reg = robosim::avr::reg;

/// The lower of the two registers for a function's first, second and third argument of up to 16 bits. The
/// first also returns a result. Source: avr-gcc's ABI, https://gcc.gnu.org/wiki/avr-gcc.
inline constexpr reg::Address kArgument[] = {24, 22, 20};

/// Returns the vector of a timer's overflow. Timer 0's is the core's clock.
inline int overflow_of(const TimerSpec& timer) {
  return timer.overflow_vector ? timer.overflow_vector : timer.vector + channels(timer);
}

}  // namespace robosim::exec::avr
