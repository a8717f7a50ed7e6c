// An AVR has several memories, each from address 0; an ELF file has one address space. avr-gcc puts flash at
// its beginning and the others far after it.
#pragma once

#include <cstdint>

namespace robosim {

constexpr std::uint32_t kAvrData = 0x800000;    ///< data memory: registers, then RAM
constexpr std::uint32_t kAvrEeprom = 0x810000;  ///< the EEPROM
constexpr std::uint32_t kAvrFuses = 0x820000;   ///< fuses; followed by lock bits and signature

}  // namespace robosim
