// What an ELF file says of itself: how large its code and variables are, and which absolute values it states.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::build {

struct ElfSize {
  std::uint64_t text = 0;         ///< loaded and never written: code and constants
  std::uint64_t data = 0;         ///< writable, with or without initial values
  std::uint64_t initialised = 0;  ///< part of `data` that has initial values
};

/// Of a 32- or 64-bit little-endian ELF file; zeros if it is none. What an AVR file has for EEPROM and fuses
/// does not count.
ElfSize elf_size(std::string_view file);

/// A symbol that has a value and no place.
struct AbsoluteSymbol {
  std::string name;
  std::uint64_t value = 0;
};

/// The absolute symbols whose names begin with `prefix`, sorted by name; none if it is no such ELF file.
std::vector<AbsoluteSymbol> absolute_symbols(std::string_view file, std::string_view prefix);

}  // namespace robosim::build
