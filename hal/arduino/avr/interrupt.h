// Defines interrupt handlers. For example, ISR(TIMER1_COMPA_vect) { ... } defines the function __vector_11,
// which the simulated chip calls.
#pragma once

#include <avr/io.h>

#define sei() robosim_enable_interrupts()
#define cli() robosim_disable_interrupts()
#define reti() return

#ifdef __cplusplus
#define ROBOSIM_HANDLER extern "C"
#else
#define ROBOSIM_HANDLER
#endif

// ISR_BLOCK, ISR_NOBLOCK and ISR_NAKED have no effect. On the host, every handler begins with interrupts off.
// A handler that calls sei() can be interrupted.
#define ISR(vector, ...)                                               \
  ROBOSIM_HANDLER void vector(void) __attribute__((used)) __VA_ARGS__; \
  ROBOSIM_HANDLER void vector(void)
#define SIGNAL(vector) ISR(vector)
#define EMPTY_INTERRUPT(vector) \
  ISR(vector) {}
#define ISR_ALIAS(vector, target)    \
  ROBOSIM_HANDLER void target(void); \
  ISR(vector) { target(); }
#define ROBOSIM_NAME_OF(vector) #vector
#define ISR_ALIASOF(target) __attribute__((alias(ROBOSIM_NAME_OF(target))))
#define ISR_BLOCK
#define ISR_NOBLOCK
#define ISR_NAKED
