// Reads facts from an ELF file: the sizes of code and variables, and the absolute symbols.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/elf/elf_file.h"

namespace robosim::build {

struct ElfSize {
  std::uint64_t text = 0;         ///< loaded and never written: code and constants
  std::uint64_t data = 0;         ///< writable, with or without initial values
  std::uint64_t initialised = 0;  ///< part of `data` that has initial values
};

/// Returns the sizes, without the EEPROM and fuses of an AVR file.
ElfSize elf_size(const ElfFile& file);

/// A symbol with a value that is not an address.
struct AbsoluteSymbol {
  std::string name;
  std::uint64_t value = 0;
};

/// Returns the absolute symbols, sorted by name.
std::vector<AbsoluteSymbol> absolute_symbols(const ElfFile& file);

}  // namespace robosim::build
