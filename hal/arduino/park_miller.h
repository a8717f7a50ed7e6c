// avr-libc's random number generator, for the targets host and stm32.
#pragma once

#include <stdint.h>

namespace robosim_hal {

/// Replaces the seed x by 7^5 x mod (2^31 - 1), and returns the new seed. Computes the product by Schrage's
/// method (Park & Miller, CACM 31(10), 1988).
inline long next_random(unsigned long& seed) {
  auto x = static_cast<int32_t>(seed);
  if (x == 0) x = 123459876;
  const int32_t high = x / 127773;
  const int32_t low = x % 127773;
  x = 16807 * low - 2836 * high;
  if (x < 0) x += 0x7fffffff;
  seed = static_cast<unsigned long>(x);
  return x;
}

}  // namespace robosim_hal
