// Models the interrupt controller on the host: selects the handlers that are due, and stores the I flag.
// Vector numbers and priorities (lowest number first) are those of the chip's vector table.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

enum Vector : uint8_t {
  kExternal0 = kChip.external_vector,  // followed by the other INTn
  kPinChange0 = kChip.change_vector,   // followed by the other pin change groups
  kWatchdog = kChip.watchdog_vector,
  kTimer2 = kChip.timers[2].vector,  // compare A; + 1: compare B; + 2: overflow
  kTimer1 = kChip.timers[1].vector,
  kTimer1Captured = kTimer1 - 1,
  kTimer0 = kChip.timers[0].vector,
  kTimer0Overflow = kTimer0 + 2,
  kUartReceived = kChip.uarts[0].vector,
  kUartEmpty = kUartReceived + 1,
  kUartSent = kUartReceived + 2,
  kAdcComplete = kChip.adc.vector,
  kEepromReady = kChip.eeprom_vector,
  kCompared = kChip.comparator.vector,
  kSpi = kChip.spi.vector,
  kTwoWire = kChip.twi.vector,
  kLines = kChip.vectors,  // all pins in `lines` (external.h); not a vector of the chip
  kVectors = kLines + 1,
};
static_assert(kVectors <= 32, "pending_interrupts() has a bit for each");

extern uint8_t status_register;  ///< SREG; bit 7 is I

inline bool interrupts_enabled() { return status_register & kI; }
/// The number of handlers that are running. It is greater than 1 if handlers are nested.
extern int handler_depth;
inline bool in_handler() { return handler_depth > 0; }
/// True once the sketch has used SPI, the two-wire interface, the comparator or the EEPROM's interrupt. Few
/// sketches use these peripherals, so the functions below skip them until then.
extern bool rare_used;
/// The number of handlers that have run since the start.
extern uint32_t handlers_run;

/// Updates all interrupt flags to the present time.
void sync_peripherals();
/// Handles the inputs that have arrived from outside until now: edges on pins, and bytes for the UART.
void take_inputs();
/// Returns the flags that are raised and enabled, one bit per vector.
uint32_t pending_interrupts();
/// Returns the time at which the next enabled flag will be raised. If `with_timer0_overflow`, the overflow of
/// Timer 0, which millis() counts, is included.
SimTime next_interrupt(bool with_timer0_overflow);
/// Returns the time of the next event that the chip causes by itself, with or without an interrupt. Timer 0's
/// overflow does not count. Returns 0 if the time is unknown: a flag is raised and enabled, a conversion is
/// in progress, the UART sends by interrupts, or `rare_used` is true.
SimTime next_alone();
/// Returns whether an enabled interrupt, a watchdog reset or tone() may act even if firmware accesses no
/// register. Interrupts of the core's clock and of Serial do not count: sketches see their effects only
/// through calls. If `held_back`, also considers interrupts that occur only after the I flag is set again.
bool may_interrupt(bool held_back);
/// Runs the handler of the most urgent pending interrupt. Returns false if none is pending or I is clear.
bool serve_interrupt();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
