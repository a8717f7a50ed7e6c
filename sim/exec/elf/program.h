// Programs for chips, as finished ELF files: what is the same for every chip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/elf/elf_file.h"

namespace robosim::exec {

/// The content of an ELF file, which is for this target; throws InputError, which names `file`, for all else.
std::string content_for(std::string_view target, std::string content, const std::string& file);

/// Throws InputError unless it is a finished program.
void check_program(const ElfFile& elf);

/// What is flashed.
struct FlashContent {
  std::vector<std::uint8_t> bytes;  ///< from the beginning of flash on; 0xFF where nothing is
  std::uint32_t code_end = 0;       ///< address
};

/// Puts these segments where they belong: none lies below `begin`, the address of flash. Throws InputError if
/// they need more than `room` bytes.
FlashContent flash_content(const ElfFile& elf, const std::vector<ElfSegment>& segments, std::uint32_t begin,
                           std::uint32_t room, const BoardSpec& board);

/// Throws InputError if the variables need more than `room` bytes.
void check_ram(const ElfFile& elf, std::uint64_t bytes, std::uint32_t room, const BoardSpec& board);

}  // namespace robosim::exec
