// Loads linked programs from ELF files. Declares the functions that do not depend on the chip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/elf/elf_file.h"

namespace robosim::exec {

/// Returns `content` if it is an ELF file for `target`. Otherwise throws InputError, which names `file`.
std::string content_for(std::string_view target, std::string content, const std::string& file);

/// Throws InputError if the file is not a linked program. Object files, for example, are not.
void check_program(const ElfFile& elf);

/// The bytes to flash.
struct FlashContent {
  std::vector<std::uint8_t> bytes;  ///< from the beginning of flash on; 0xFF in gaps
  std::uint32_t code_end = 0;       ///< address after the last byte of code
};

/// Copies segments to their addresses in flash. `begin` is the first address of flash; no segment may lie
/// below this address. Throws InputError if the segments need more than `room` bytes.
FlashContent flash_content(const ElfFile& elf, const std::vector<ElfSegment>& segments, std::uint32_t begin,
                           std::uint32_t room, const BoardSpec& board);

/// Throws InputError if the variables, which take `bytes` bytes, exceed the RAM of `room` bytes.
void check_ram(const ElfFile& elf, std::uint64_t bytes, std::uint32_t room, const BoardSpec& board);

}  // namespace robosim::exec
