// Names registers inside the emulated chip, and the registers that calls use.
#pragma once

#include "hal/board/avr_registers.h"
#include "hal/board/chip_spec.h"

namespace robosim::exec::avr {

namespace reg = robosim::avr::reg;

/// Lower registers of the pairs for a function's first three arguments of up to 16 bits. The first pair also
/// returns a result. Source: avr-gcc's ABI, https://gcc.gnu.org/wiki/avr-gcc.
inline constexpr reg::Address kArgument[] = {24, 22, 20};

/// Returns the vector of a timer's overflow. The Arduino core's clock uses timer 0's overflow.
inline int overflow_of(const TimerSpec& timer) {
  return timer.overflow_vector ? timer.overflow_vector : timer.vector + channels(timer);
}

}  // namespace robosim::exec::avr
