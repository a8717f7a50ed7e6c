// Who has called the function that is about to begin.
#pragma once

#include <cstdint>

#include "sim/avr/cpu.h"

namespace robosim::exec::avr {

/// Its call, a flash address: or the middle of it, of a `call`, which is the same place for debug
/// information.
inline std::uint32_t call_site(const robosim::avr::Cpu& cpu) {
  std::uint32_t words = 0;
  for (int i = 1; i <= cpu.chip().return_address_bytes; ++i)
    words = words << 8 | cpu.data[cpu.sp() + static_cast<unsigned>(i)];
  return 2 * words - 2;
}

}  // namespace robosim::exec::avr
