// The interrupt controller: which handlers are due, and the I flag. Numbers and priority (lowest first) as in
// the chip's vector table.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

enum Vector : uint8_t {
  kExternal0 = kChip.external_vector,  // the others follow
  kPinChange0 = kChip.change_vector,   // the other groups follow
  kWatchdog = kChip.watchdog_vector,
  kTimer2 = kChip.timers[2].vector,  // compare A; +1 compare B; +2 overflow
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
  kLines = kChip.vectors,  // no vector of the chip: external.h
  kVectors = kLines + 1,
};
static_assert(kVectors <= 32, "pending_interrupts() has a bit for each");

extern uint8_t status_register;  ///< SREG; bit 7 is I

inline bool interrupts_enabled() { return status_register & 0x80; }
/// How many handlers run, one within another; and whether one does.
extern int handler_depth;
inline bool in_handler() { return handler_depth > 0; }
/// Whether the sketch has ever switched on SPI, two-wire interface, comparator or the EEPROM's interrupt: few
/// do, and until then nothing comes of these.
extern bool rare_used;
/// How many handlers have run.
extern uint32_t handlers_run;

/// Brings all flags up to the present moment.
void sync_peripherals();
/// The same of what comes from outside alone.
void take_inputs();
/// The flags that are raised and enabled, one bit a vector.
uint32_t pending_interrupts();
/// When the next enabled flag will be raised; with or without the overflow of Timer 0 that millis() counts.
SimTime next_interrupt(bool with_timer0_overflow);
/// If nothing is raised and enabled, and no conversion goes on: when the next thing happens by itself but for
/// the overflow of Timer 0, whether it interrupts or not. Else 0.
SimTime next_alone();
/// Whether an interrupt is enabled that may come though firmware touches no register any more. Those of the
/// core's clock and of its Serial do not count: they change nothing that a sketch could see without a call.
/// With `held_back` those count that come only once the I flag is set again.
bool may_interrupt(bool held_back);
/// Runs the handler of the most urgent pending interrupt; false if there is none, or I is clear.
bool serve_interrupt();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
