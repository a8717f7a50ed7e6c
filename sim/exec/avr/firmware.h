// Loads a program for an AVR from an ELF file: the contents of the chip's memories, and the addresses of
// symbols. An Intel HEX file provides only the flash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/avr/registers.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec::avr {

/// Prefix of the functions that gcc's checks call on failure. The name of the check follows the prefix.
constexpr std::string_view kCheckPrefix = "__ubsan_handle_";

struct Firmware {
  std::string file;
  const ChipSpec* chip = nullptr;
  std::vector<std::uint8_t> flash;   ///< content of flash: code, constants, initial values of variables
  std::vector<std::uint8_t> eeprom;  ///< initial content of the EEPROM; may be shorter than the EEPROM
  bool named = true;                 ///< false if read from a .hex file, which has no symbols
  std::uint32_t code_end = 0;        ///< end of .text
  std::uint16_t globals_end = 0;     ///< data address after the last variable: the start of the heap
  std::uint32_t ram_bytes = 0;       ///< size of the variables
  Symbols symbols;                   ///< functions (flash from address 0) and variables (from kAvrData)
  /// Last address of RAM, where the stack starts. An image built with --sanitize may need more than the
  /// chip's memories. Such an image gets RAM up to the start of its stack, and 64 KB of flash.
  std::uint16_t last_ram = 0;
  bool needs_larger_chip() const { return last_ram + 1u != ram_end(*chip); }

  /// Returns the instruction word at an even flash address.
  int word(std::uint32_t pc) const { return flash[pc] | flash[pc + 1] << 8; }

  /// Reads a program. Throws InputError if the file is missing, or is not an AVR executable or Intel HEX
  /// file. Also throws if the program exceeds the board's flash, or is not linked for the board's chip.
  static Firmware read(const std::filesystem::path& file, const BoardSpec& board);

  /// Returns the address of a symbol, if the image contains the symbol.
  std::optional<std::uint32_t> find(const std::string& name) const;
  /// Returns the address of a variable in data memory, if the image contains the variable.
  std::optional<std::uint16_t> find_variable(const std::string& name) const;
  /// Returns the function that contains a flash address; null if no function does.
  const Symbol* function_at(std::uint32_t pc) const;
};

}  // namespace robosim::exec::avr
