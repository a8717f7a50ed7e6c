// avr-libc's <util/parity.h>.
#pragma once

#include <stdint.h>

/// Returns 1 if an odd number of bits is set, else 0.
static inline uint8_t parity_even_bit(uint8_t value) { return (uint8_t)(__builtin_popcount(value) & 1); }
