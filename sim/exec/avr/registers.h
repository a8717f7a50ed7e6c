// Names the registers in which avr-gcc passes arguments, and the interrupt of a timer's overflow.
#pragma once

#include "hal/board/avr_registers.h"
#include "hal/board/chip_spec.h"

namespace robosim::exec::avr {

namespace reg = robosim::avr::reg;

/// A function's first three arguments of up to 16 bits are in pairs of registers. These are the lower
/// registers of the pairs. The first pair also returns the result. Source: https://gcc.gnu.org/wiki/avr-gcc.
inline constexpr reg::Address kArgument[] = {24, 22, 20};

/// Returns the interrupt vector of a timer's overflow. The Arduino core's clock uses the overflow of timer 0.
inline int overflow_of(const TimerSpec& timer) {
  return timer.overflow_vector ? timer.overflow_vector : timer.vector + channels(timer);
}

}  // namespace robosim::exec::avr
