// Reads an ELF file for an STM32F103: the content of the chip's flash and the symbols.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "hal/stm32/addresses.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec::stm32 {

struct Firmware {
  std::string file;
  std::vector<std::uint8_t> flash;          ///< content of the whole flash; gaps are 0xFF
  std::uint32_t flash_bytes = 0;            ///< number of bytes used from the start of flash
  std::uint32_t ram_bytes = 0;              ///< size of all variables
  robosim::stm32::Address globals_end = 0;  ///< end of the last variable: the start of the heap
  std::uint32_t code_end = 0;
  Symbols symbols;

  /// Returns the halfword at an even address in flash.
  std::uint16_t half(std::uint32_t address) const {
    const std::size_t at = address - robosim::stm32::kFlash;
    return at + 1 < flash.size() ? static_cast<std::uint16_t>(flash[at] | flash[at + 1] << 8) : 0xFFFF;
  }
  bool has_code(std::uint32_t address) const {
    return address >= robosim::stm32::kFlash && address < code_end;
  }

  /// Reads a program. Throws InputError if the file is missing or not an executable for an STM32F103. Also
  /// throws InputError if the program exceeds the board's flash or RAM.
  static Firmware read(const std::filesystem::path& file, const BoardSpec& board);
};

}  // namespace robosim::exec::stm32
