#include "sim/exec/stm32/firmware.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/elf/program.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

void load_flash(const ElfFile& elf, const BoardSpec& board, Firmware& firmware) {
  const std::vector<ElfSegment> segments = elf.segments();
  for (const ElfSegment& segment : segments) {
    if (segment.address < kFlash || segment.address + segment.bytes.size() > kFlash + kFlashBytes) {
      throw InputError(
          {firmware.file},
          fmt::format("the image has content for address 0x{:08X}, where the {} has no flash: expected an "
                      "image that is linked for its chip",
                      segment.address, board.name));
    }
  }
  FlashContent flash = flash_content(elf, segments, kFlash, board.flash_bytes, board);
  firmware.flash_bytes = static_cast<std::uint32_t>(flash.bytes.size());
  firmware.code_end = flash.code_end;
  firmware.flash = std::move(flash.bytes);
  firmware.flash.resize(kFlashBytes, 0xFF);
}

void load_symbols(const ElfFile& elf, const BoardSpec& board, Firmware& firmware) {
  std::uint64_t globals_end = kRam;
  for (const ElfSection& section : elf.sections()) {
    if (section.loaded && section.size > 0 && section.address >= kRam && section.address < kRam + kRamBytes)
      globals_end = std::max(globals_end, section.address + section.size);
  }
  check_ram(elf, globals_end - kRam, board.ram_bytes, board);
  firmware.globals_end = static_cast<Address>(globals_end);
  for (const ElfSymbol& symbol : elf.symbols()) {
    const bool code = symbol.kind == ElfSymbol::Kind::function;
    if (symbol.absolute || (!code && symbol.kind != ElfSymbol::Kind::object)) continue;
    // Clears the lowest bit of a function's address, which selects Thumb code.
    const auto address = static_cast<Address>(symbol.value);
    firmware.symbols.add({std::string(symbol.name), code ? address & ~1u : address,
                          static_cast<std::uint32_t>(symbol.size), code});
  }
  firmware.symbols.sort();
}

}  // namespace

Firmware Firmware::read(const std::filesystem::path& file, const BoardSpec& board) {
  const ElfFile elf(content_for("stm32", read_file(file), file.string()), file.string());
  check_program(elf);
  Firmware firmware;
  firmware.file = file.string();
  if (std::string_view(board.chip->name) != kStm32f103c8.name)
    throw InputError(
        {firmware.file},
        fmt::format("expected an image for the robot's board, the {}, got one for a Blue Pill", board.name));
  load_flash(elf, board, firmware);
  load_symbols(elf, board, firmware);
  if (firmware.flash_bytes < 64 * 4) throw InputError({firmware.file}, "the image has no code");
  constexpr std::uint16_t kErased = 0xFFFF;
  if (firmware.half(kFlash + 2) == kErased && firmware.half(kFlash + 6) == kErased)
    throw InputError(
        {firmware.file},
        fmt::format("the image has no vector table at 0x{:08X}: it is linked for a boot loader", kFlash));
  firmware.ram_bytes = firmware.globals_end - kRam;
  return firmware;
}

}  // namespace robosim::exec::stm32
