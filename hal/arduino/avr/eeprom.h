// Accesses the EEPROM by address, with avr-libc's interface. EEMEM variables have a linker section of their
// own. A variable's offset in this section is its EEPROM address. Initial values of EEMEM variables are not
// loaded, because Arduino's upload does not load them either.
#pragma once

#include <avr/io.h>
#include <stddef.h>

#define EEMEM __attribute__((section("robosim_eeprom")))
#define eeprom_is_ready() 1
#define eeprom_busy_wait() ((void)0)

#ifdef __cplusplus
extern "C" {
#endif

uint8_t eeprom_read_byte(const uint8_t* address);
uint16_t eeprom_read_word(const uint16_t* address);
uint32_t eeprom_read_dword(const uint32_t* address);
float eeprom_read_float(const float* address);
void eeprom_read_block(void* to, const void* address, size_t size);

void eeprom_write_byte(uint8_t* address, uint8_t value);
void eeprom_write_word(uint16_t* address, uint16_t value);
void eeprom_write_dword(uint32_t* address, uint32_t value);
void eeprom_write_float(float* address, float value);
void eeprom_write_block(const void* from, void* address, size_t size);

/// Write only those bytes that differ, because an EEPROM cell endures only 100,000 writes.
void eeprom_update_byte(uint8_t* address, uint8_t value);
void eeprom_update_word(uint16_t* address, uint16_t value);
void eeprom_update_dword(uint32_t* address, uint32_t value);
void eeprom_update_float(float* address, float value);
void eeprom_update_block(const void* from, void* address, size_t size);

#ifdef __cplusplus
}
#endif
