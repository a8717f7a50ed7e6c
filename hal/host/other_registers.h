// Registers other than those of ports, timers, converter and serial lines: EEPROM and comparator, registers
// that only store what is written, and registers that the host lacks. Use of a missing register is reported,
// since the run then differs from the chip.
#pragma once

#include <stdint.h>

namespace robosim {
namespace host {

uint8_t read_other(uint8_t address);
void write_other(uint8_t address, uint8_t value);
/// Returns the bits SM and SE.
uint8_t sleep_control();

/// Records that the sketch uses a feature that the host lacks. `what` is a literal with the usual name:
/// "CLKPR".
void note_lack(const char* what);

}  // namespace host
}  // namespace robosim
