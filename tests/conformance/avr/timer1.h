// Helpers for programs about an ATtiny85's timer 1. A synchroniser delays accesses to the timer's registers
// by a cycle or two (2586Q, figure 12-2). The programs therefore read in the middle of the timer's ticks.
#pragma once

#include "report.h"

#define CLOCK_BY_64 (_BV(CS12) | _BV(CS11) | _BV(CS10))

/// Resets the prescaler's counter (PSR1), and sets TCNT1 to `count`. Returns the register `from`, read
/// slightly more than `cycles` cycles later.
#define AFTER_CYCLES(count, cycles, from) \
  ({                                      \
    GTCCR |= _BV(PSR1);                   \
    TCNT1 = (count);                      \
    __builtin_avr_delay_cycles(cycles);   \
    uint8_t found_ = (from);              \
    found_;                               \
  })
/// Returns the register `from`, read `halves` half ticks later; a tick has 64 cycles.
#define AFTER_HALF_TICKS(count, halves, from) AFTER_CYCLES(count, 32 * (halves), from)
