// How large an ELF file's code and variables are.
#pragma once

#include <cstdint>
#include <string_view>

namespace robosim::sketch {

struct ElfSize {
  std::uint64_t text = 0;  ///< loaded and never written: code and constants
  std::uint64_t data = 0;  ///< loaded and writable, with or without initial values
};

/// Of a 32- or 64-bit little-endian ELF file; zeros if it is none.
ElfSize elf_size(std::string_view file);

}  // namespace robosim::sketch
