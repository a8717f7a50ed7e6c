// Loads programs for chips, as finished ELF files: the part that is equal for every chip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/elf/elf_file.h"

namespace robosim::exec {

/// Returns the content of an ELF file for this target; throws InputError, which names `file`, for anything
/// else.
std::string content_for(std::string_view target, std::string content, const std::string& file);

/// Throws InputError unless it is a finished program.
void check_program(const ElfFile& elf);

/// The bytes to flash.
struct FlashContent {
  std::vector<std::uint8_t> bytes;  ///< from the beginning of flash on; gaps are 0xFF
  std::uint32_t code_end = 0;       ///< address
};

/// Places these segments at their addresses; none lies below `begin`, the address of flash. Throws InputError
/// if they need more than `room` bytes.
FlashContent flash_content(const ElfFile& elf, const std::vector<ElfSegment>& segments, std::uint32_t begin,
                           std::uint32_t room, const BoardSpec& board);

/// Throws InputError if the variables need more than `room` bytes.
void check_ram(const ElfFile& elf, std::uint64_t bytes, std::uint32_t room, const BoardSpec& board);

}  // namespace robosim::exec
