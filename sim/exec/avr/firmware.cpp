#include "sim/exec/avr/firmware.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/elf/avr_addresses.h"
#include "sim/exec/avr/registers.h"
#include "sim/exec/elf/program.h"

namespace robosim::exec::avr {
namespace {

constexpr std::uint32_t kEnlargedFlash = 0x10000;  // all that a data pointer reaches

void load_symbols(const ElfFile& elf, const BoardSpec& board, Firmware& firmware) {
  const std::uint64_t first_ram = kAvrData + firmware.chip->ram_address;
  std::uint64_t data_end = first_ram;
  for (const ElfSection& section : elf.sections()) {
    if (section.loaded && section.address >= kAvrData && section.address < kAvrEeprom)
      data_end = std::max(data_end, section.address + section.size);
  }
  std::uint64_t stack = 0;
  bool checks = false;
  for (const ElfSymbol& symbol : elf.symbols()) {
    if (symbol.kind == ElfSymbol::Kind::file_or_section) continue;
    if (symbol.name == "__stack") stack = symbol.value;
    if (symbol.name.empty() || symbol.absolute) continue;
    checks |= symbol.name.starts_with(kCheckPrefix);
    firmware.symbols.add({std::string(symbol.name), static_cast<std::uint32_t>(symbol.value),
                          static_cast<std::uint32_t>(symbol.size), symbol.value < kAvrData});
  }
  firmware.symbols.sort();
  if (checks && stack >= ram_end(*firmware.chip) && stack <= 0xFFFF)
    firmware.last_ram = static_cast<std::uint16_t>(stack);
  const std::uint64_t ram_bytes = data_end - first_ram;
  check_ram(elf, ram_bytes,
            firmware.needs_larger_chip() ? firmware.last_ram - firmware.chip->ram_address : board.ram_bytes,
            board);
  firmware.ram_bytes = static_cast<std::uint32_t>(ram_bytes);
  firmware.globals_end = static_cast<std::uint16_t>(data_end - kAvrData);
}

void load_flash(const ElfFile& elf, const BoardSpec& board, Firmware& firmware) {
  std::vector<ElfSegment> segments = elf.segments();
  std::erase_if(segments, [](const ElfSegment& segment) { return segment.address >= kAvrData; });
  const std::uint32_t room = firmware.needs_larger_chip() ? kEnlargedFlash : board.flash_bytes;
  FlashContent flash = flash_content(elf, segments, 0, room, board);
  firmware.flash = std::move(flash.bytes);
  firmware.code_end = flash.code_end;
}

}  // namespace

Firmware Firmware::read(const std::filesystem::path& file, const BoardSpec& board) {
  const ElfFile elf(read_file(file), file.string());
  check_program(elf, ElfFile::Machine::avr, "an AVR chip");
  Firmware firmware;
  firmware.file = file.string();
  firmware.chip = board.chip;
  firmware.last_ram = static_cast<std::uint16_t>(ram_end(*board.chip) - 1);
  if (std::string_view(board.chip->target) != "avr")
    throw InputError({firmware.file},
                     fmt::format("is for an AVR chip, and the robot's board is the {}", board.name));
  load_symbols(elf, board, firmware);
  load_flash(elf, board, firmware);
  if (firmware.code_end < 4) throw InputError({firmware.file}, "holds no code");
  return firmware;
}

std::optional<std::uint32_t> Firmware::find(const std::string& name) const {
  const Symbol* const symbol = symbols.find(name);
  return symbol ? std::optional(symbol->address) : std::nullopt;
}

std::optional<std::uint16_t> Firmware::find_variable(const std::string& name) const {
  const auto address = find(name);
  if (!address || *address < kAvrData || *address >= kAvrEeprom) return std::nullopt;
  return static_cast<std::uint16_t>(*address - kAvrData);
}

const Symbol* Firmware::function_at(std::uint32_t pc) const {
  return pc < code_end ? symbols.function_at(pc) : nullptr;
}

}  // namespace robosim::exec::avr
