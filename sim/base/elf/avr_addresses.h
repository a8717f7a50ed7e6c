// Defines the addresses of an AVR's memories in the ELF files of avr-gcc. An AVR has several memories, and
// each memory begins at address 0. An ELF file has one address space: flash starts at address 0, and the
// other memories at the addresses below.
#pragma once

#include <cstdint>

namespace robosim {

constexpr std::uint32_t kAvrData = 0x800000;    ///< registers, then RAM
constexpr std::uint32_t kAvrEeprom = 0x810000;  ///< EEPROM
constexpr std::uint32_t kAvrFuses = 0x820000;   ///< fuses; followed by lock bits and signature

}  // namespace robosim
