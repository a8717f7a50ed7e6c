// The interrupt controller: which handlers are due, and the I flag. Numbers and priority (lowest first) as in
// the ATmega328P's vector table (datasheet, table 12-6).
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {
namespace host {

enum Vector : uint8_t {
  kExternal0 = 1,
  kExternal1 = 2,
  kPinChange0 = 3,  // port B; 4 = port C, 5 = port D
  kTimer2 = 7,      // compare A; +1 compare B; +2 overflow
  kTimer1 = 11,
  kTimer0 = 14,
  kTimer0Overflow = 16,
  kUartReceived = 18,
  kUartEmpty = 19,
  kUartSent = 20,
  kAdcComplete = 21,
  kLines = 26,  // no vector of the chip: external.h
  kVectors = 27,
};

extern uint8_t status_register;  ///< SREG; bit 7 is I

inline bool interrupts_enabled() { return status_register & 0x80; }
/// Whether a handler runs.
bool in_handler();
/// How many handlers have run.
extern uint32_t handlers_run;

/// Brings all flags up to the present moment.
void sync_peripherals();
/// The flags that are raised and enabled, one bit a vector.
uint32_t pending_interrupts();
/// When the next enabled flag will be raised; with or without the overflow of Timer 0 that millis() counts.
SimTime next_interrupt(bool with_timer0_overflow);
/// Runs the handler of the most urgent pending interrupt; false if there is none, or I is clear.
bool serve_interrupt();

}  // namespace host
}  // namespace robosim
