// avr-libc's busy waits, which take an exact number of cycles.
#pragma once

#include <stdint.h>

#include "hal/host/registers.h"

/// Waits for `us` microseconds. Rounds the number of cycles up, as avr-libc does.
static inline void _delay_us(double us) {
  const double cycles = us * (F_CPU / 1e6);
  const uint64_t whole = (uint64_t)cycles;
  robosim_spend_cycles(cycles > (double)whole ? whole + 1 : whole);
}
static inline void _delay_ms(double ms) { _delay_us(ms * 1000.0); }
static inline void _delay_loop_1(uint8_t count) { robosim_spend_cycles(3u * (count ? count : 256u)); }
static inline void _delay_loop_2(uint16_t count) { robosim_spend_cycles(4u * (count ? count : 65536u)); }
