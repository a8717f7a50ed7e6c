// Finds the caller of a function that is about to start.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/cpu.h"

namespace robosim::detect::avr {

/// Returns the flash address of the last word of the call instruction. Debug information gives the same line
/// for this word as for the first word, if the instruction has two words.
inline std::uint32_t call_site(const robosim::avr::Cpu& cpu) {
  std::uint32_t words = 0;
  for (int i = 1; i <= cpu.chip().return_address_bytes; ++i)
    words = words << 8 | cpu.data[cpu.sp() + static_cast<unsigned>(i)];
  return 2 * words - 2;
}

}  // namespace robosim::detect::avr
