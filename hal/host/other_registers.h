// Registers beside those of ports, timers, converter and serial lines: EEPROM and comparator, those that only
// keep what is written, and those that the host lacks, of which it tells that a sketch uses them. What it
// does then says nothing of the chip.
#pragma once

#include <stdint.h>

namespace robosim {
namespace host {

uint8_t read_other(uint8_t address);
void write_other(uint8_t address, uint8_t value);
/// SM and SE.
uint8_t sleep_control();

/// The sketch uses something, as its author would name it ("CLKPR"), that the host lacks. `what` is a
/// literal.
void note_lack(const char* what);

}  // namespace host
}  // namespace robosim
