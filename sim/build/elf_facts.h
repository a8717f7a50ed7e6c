// What an ELF file says of itself: how large its code and variables are, and which absolute values it states.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/elf/elf_file.h"

namespace robosim::build {

struct ElfSize {
  std::uint64_t text = 0;         ///< loaded and never written: code and constants
  std::uint64_t data = 0;         ///< writable, with or without initial values
  std::uint64_t initialised = 0;  ///< part of `data` that has initial values
};

/// What an AVR file has for EEPROM and fuses does not count.
ElfSize elf_size(const ElfFile& file);

/// A symbol that has a value and no place.
struct AbsoluteSymbol {
  std::string name;
  std::uint64_t value = 0;
};

/// Sorted by name.
std::vector<AbsoluteSymbol> absolute_symbols(const ElfFile& file);

}  // namespace robosim::build
