// Defines ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { ... }. Interrupts are off inside the block. Every exit from the
// block restores their previous state.
#pragma once

#include <avr/interrupt.h>

static inline void robosim_restore_sreg(const uint8_t* saved) { SREG = *saved; }
static inline void robosim_sei_after(const uint8_t*) { sei(); }
static inline void robosim_cli_after(const uint8_t*) { cli(); }
static inline uint8_t robosim_cli_once(void) {
  cli();
  return 1;
}
static inline uint8_t robosim_sei_once(void) {
  sei();
  return 1;
}

#define ATOMIC_RESTORESTATE \
  uint8_t robosim_saved_sreg __attribute__((unused, cleanup(robosim_restore_sreg))) = SREG
#define ATOMIC_FORCEON uint8_t robosim_saved_sreg __attribute__((unused, cleanup(robosim_sei_after))) = 0
#define NONATOMIC_RESTORESTATE ATOMIC_RESTORESTATE
#define NONATOMIC_FORCEOFF uint8_t robosim_saved_sreg __attribute__((unused, cleanup(robosim_cli_after))) = 0

#define ATOMIC_BLOCK(type) for (type, robosim_todo = robosim_cli_once(); robosim_todo; robosim_todo = 0)
#define NONATOMIC_BLOCK(type) for (type, robosim_todo = robosim_sei_once(); robosim_todo; robosim_todo = 0)
