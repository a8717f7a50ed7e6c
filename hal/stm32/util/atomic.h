// Defines ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { ... }. Interrupts are off inside the block. Every exit from the
// block restores their previous state.
#pragma once

#include <avr/interrupt.h>

static inline uint32_t robosim_primask(void) {
  uint32_t masked;
  __asm__ volatile("mrs %0, primask" : "=r"(masked)::"memory");
  return masked;
}
static inline void robosim_restore(const uint32_t* saved) {
  __asm__ volatile("msr primask, %0" ::"r"(*saved) : "memory");
}
static inline uint8_t robosim_cli_once(void) {
  cli();
  return 1;
}
static inline uint8_t robosim_sei_once(void) {
  sei();
  return 1;
}

#define ATOMIC_RESTORESTATE \
  uint32_t robosim_saved __attribute__((unused, cleanup(robosim_restore))) = robosim_primask()
#define ATOMIC_FORCEON uint32_t robosim_saved __attribute__((unused, cleanup(robosim_restore))) = 0
#define NONATOMIC_RESTORESTATE ATOMIC_RESTORESTATE
#define NONATOMIC_FORCEOFF uint32_t robosim_saved __attribute__((unused, cleanup(robosim_restore))) = 1

#define ATOMIC_BLOCK(type) for (type, robosim_todo = robosim_cli_once(); robosim_todo; robosim_todo = 0)
#define NONATOMIC_BLOCK(type) for (type, robosim_todo = robosim_sei_once(); robosim_todo; robosim_todo = 0)
