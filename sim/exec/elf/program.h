// Loads finished programs for chips from ELF files. This part is common to all chips.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/elf/elf_file.h"

namespace robosim::exec {

/// Returns the content if it is an ELF file for this target. Throws InputError, which names `file`,
/// otherwise.
std::string content_for(std::string_view target, std::string content, const std::string& file);

/// Throws InputError unless the file is a finished program.
void check_program(const ElfFile& elf);

/// The bytes to flash.
struct FlashContent {
  std::vector<std::uint8_t> bytes;  ///< from the beginning of flash on; 0xFF in gaps
  std::uint32_t code_end = 0;       ///< address after the last byte of code
};

/// Places these segments at their addresses, none of which is below `begin`, the address of flash. Throws
/// InputError if they need more than `room` bytes.
FlashContent flash_content(const ElfFile& elf, const std::vector<ElfSegment>& segments, std::uint32_t begin,
                           std::uint32_t room, const BoardSpec& board);

/// Throws InputError if variables of `bytes` bytes exceed `room`.
void check_ram(const ElfFile& elf, std::uint64_t bytes, std::uint32_t room, const BoardSpec& board);

}  // namespace robosim::exec
