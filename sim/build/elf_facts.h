// Reads facts from an ELF file: the sizes of its code and variables, and the absolute values that it defines.
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

/// Does not count an AVR file's EEPROM and fuses.
ElfSize elf_size(const ElfFile& file);

/// A symbol with a value, but without an address.
struct AbsoluteSymbol {
  std::string name;
  std::uint64_t value = 0;
};

/// Sorted by name.
std::vector<AbsoluteSymbol> absolute_symbols(const ElfFile& file);

}  // namespace robosim::build
