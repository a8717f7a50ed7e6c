// Accesses registers that do not belong to ports, timers, converter or serial lines. These registers belong
// to EEPROM and comparator, or only store their value, or are not simulated on the host. The use of a
// register that is not simulated is reported, because the run then differs from the chip.
#pragma once

#include <stdint.h>

namespace robosim {
namespace host {

uint8_t read_other(uint8_t address);
void write_other(uint8_t address, uint8_t value);
/// Returns SMCR, which has the bits SM and SE.
uint8_t sleep_control();

/// Reports that the sketch uses a feature that the host does not simulate. `what` is a string literal with
/// the usual name: "CLKPR".
void note_lack(const char* what);

}  // namespace host
}  // namespace robosim
