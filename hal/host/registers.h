// Declares the functions of the simulated chip (hal/host) that the Arduino headers (hal/arduino) call:
// registers, interrupts, sleep, EEPROM. This header is plain C, because a sketch's .c files include it, too.
// Every name begins with robosim_.
//
// A register is identified by its address in the chip's data space (chip.h). Therefore only avr-libc lists
// the names of registers.
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Address of a register in data space, 0x20..0xFF.
typedef uint8_t robosim_register;

uint8_t robosim_read8(robosim_register address);
void robosim_write8(robosim_register address, uint8_t value);
/// Reads a 16-bit register, identified by the address of its low byte: TCNT1, ICR1, OCR1A, OCR1B, ADC.
uint16_t robosim_read16(robosim_register address);
void robosim_write16(robosim_register address, uint16_t value);

/// Size of the chip's data space, for registers in memory (register_memory.h).
#define ROBOSIM_REGISTER_BYTES 256
extern uint8_t robosim_register_memory[ROBOSIM_REGISTER_BYTES];

/// Set and clear the I flag of SREG: sei() and cli().
void robosim_enable_interrupts(void);
void robosim_disable_interrupts(void);

/// Spends `cycles` CPU cycles in a busy loop (_delay_us and similar). Interrupts are served during this time.
void robosim_spend_cycles(uint64_t cycles);
/// Sends bytes as pulses on a digital pin, the highest bit first, like a loop in assembly code. Each bit
/// lasts `period` CPU cycles. The pin is high for the first `one` cycles of a 1, and for the first `zero`
/// cycles of a 0. Interrupts should be off.
void robosim_send_pulses(uint8_t pin, const uint8_t* bytes, size_t count, int zero, int one, int period);
/// Executes SLEEP: waits for an interrupt if SE is set in SMCR, else returns at once.
void robosim_sleep(void);
/// Executes WDR.
void robosim_watchdog_reset(void);

/// Access one byte of EEPROM. The address is taken modulo the EEPROM's size, as on the chip. A write takes
/// 3.4 ms.
uint8_t robosim_eeprom_read(uint16_t address);
void robosim_eeprom_write(uint16_t address, uint8_t value);

#ifdef __cplusplus
}  // extern "C"
#endif
