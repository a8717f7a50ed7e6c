// Registers beside those of ports, timers, converter and serial lines: EEPROM and comparator, DIDR0 and
// DIDR1, and those that only keep what is written.
#pragma once

#include <stdint.h>

namespace robosim {
namespace host {

uint8_t read_other(uint8_t address);
void write_other(uint8_t address, uint8_t value);
/// SM and SE.
uint8_t sleep_control();

}  // namespace host
}  // namespace robosim
