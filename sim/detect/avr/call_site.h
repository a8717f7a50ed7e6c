// Finds the caller of a function that is about to start.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/cpu.h"

namespace robosim::detect::avr {

/// Returns the flash address of the call. For the instruction `call`, this is the address of its second word,
/// for which debug information gives the same line.
inline std::uint32_t call_site(const robosim::avr::Cpu& cpu) {
  std::uint32_t words = 0;
  for (int i = 1; i <= cpu.chip().return_address_bytes; ++i)
    words = words << 8 | cpu.data[cpu.sp() + static_cast<unsigned>(i)];
  return 2 * words - 2;
}

}  // namespace robosim::detect::avr
