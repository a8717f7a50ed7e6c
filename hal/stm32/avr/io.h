// Provides the part of avr-libc's <avr/io.h> that is independent of an AVR's registers.
#pragma once

#include <stdint.h>

#define _BV(bit) (1 << (bit))
#define E2END 1023

#ifdef __cplusplus
extern "C" {
#endif

/// Access the emulated EEPROM (hal/stm32/eeprom.h).
uint8_t robosim_eeprom_read(uint16_t address);
void robosim_eeprom_write(uint16_t address, uint8_t value);

#ifdef __cplusplus
}
#endif

/// Spends at least `count` cycles.
static inline void robosim_spend_cycles(uint32_t count) {
  while (count--) __asm__ volatile("nop");
}
