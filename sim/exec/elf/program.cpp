#include "sim/exec/elf/program.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/elf/elf_target.h"
#include "sim/base/error.h"

namespace robosim::exec {

std::string content_for(std::string_view target, std::string content, const std::string& file) {
  const std::string is = target_of_elf(content, file);
  if (is != target) throw wrong_target(file, is, target);
  return content;
}

void check_program(const ElfFile& elf) {
  if (!elf.is_program())
    throw InputError({elf.file()}, "expected a finished program, got another kind of ELF file");
}

FlashContent flash_content(const ElfFile& elf, const std::vector<ElfSegment>& segments, std::uint32_t begin,
                           std::uint32_t room, const BoardSpec& board) {
  FlashContent flash{{}, begin};
  std::uint64_t size = 0;
  for (const ElfSegment& segment : segments)
    size = std::max(size, segment.address - begin + segment.bytes.size());
  if (size > room) {
    throw InputError({elf.file()}, fmt::format("requires {} bytes of flash, but the {} has {} for a sketch",
                                               size, board.name, room));
  }
  flash.bytes.assign(size, 0xFF);
  for (const ElfSegment& segment : segments) {
    const std::size_t at = segment.address - begin;
    std::copy(segment.bytes.begin(), segment.bytes.end(),
              flash.bytes.begin() + static_cast<std::ptrdiff_t>(at));
    if (segment.code)
      flash.code_end =
          std::max(flash.code_end, static_cast<std::uint32_t>(segment.address + segment.bytes.size()));
  }
  return flash;
}

void check_ram(const ElfFile& elf, std::uint64_t bytes, std::uint32_t room, const BoardSpec& board) {
  if (bytes > room) {
    throw InputError({elf.file()},
                     fmt::format("requires {} bytes of RAM for its variables, but the {} has {}", bytes,
                                 board.name, room));
  }
}

}  // namespace robosim::exec
