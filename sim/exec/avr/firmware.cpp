#include "sim/exec/avr/firmware.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "sim/base/elf/avr_addresses.h"
#include "sim/base/elf/avr_device.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/avr/registers.h"
#include "sim/exec/elf/intel_hex.h"
#include "sim/exec/elf/program.h"
#include "sim/mcu/avr/decode.h"

namespace robosim::exec::avr {
namespace {

constexpr std::uint32_t kEnlargedFlash = 0x10000;  // the number of bytes that a data pointer can address

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

void load_eeprom(const ElfFile& elf, Firmware& firmware) {
  const std::uint32_t end = kAvrEeprom + firmware.chip->eeprom_bytes;
  for (const ElfSegment& segment : elf.segments()) {
    // Skips the fuses, lock bits and signature after the EEPROM, because the board defines them.
    if (segment.address < kAvrEeprom || segment.address >= kAvrFuses) continue;
    if (segment.address + segment.bytes.size() > end) {
      throw InputError({firmware.file}, fmt::format("too much content for the EEPROM: expected at most {} "
                                                    "bytes, got {}",
                                                    firmware.chip->eeprom_bytes,
                                                    segment.address + segment.bytes.size() - kAvrEeprom));
    }
    const std::size_t at = segment.address - kAvrEeprom;
    firmware.eeprom.resize(std::max(firmware.eeprom.size(), at + segment.bytes.size()), 0xFF);
    std::copy(segment.bytes.begin(), segment.bytes.end(),
              firmware.eeprom.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

/// Finds the end of the variables in the start-up code of avr-libc. The start-up code initialises the
/// variables through X (r27:r26), and compares X with the end of the variables. It uses `ldi rN, high`, and
/// later `cpi r26, low` and `cpc r27, rN`.
std::uint16_t end_of_variables(const Firmware& firmware) {
  constexpr std::size_t kStartupWords = 256;  // including the interrupt vectors
  constexpr std::uint8_t kX = 26;
  using robosim::avr::Op;
  const std::size_t bytes = std::min(firmware.flash.size() & ~std::size_t{1}, 2 * kStartupWords);
  const auto code = robosim::avr::decode(std::span(firmware.flash).first(bytes));
  std::array<std::uint8_t, 32> loaded{};
  unsigned end = firmware.chip->ram_address;
  for (std::size_t i = 0; i + 1 < code.size(); ++i) {
    if (code[i].op == Op::ldi) loaded[code[i].a] = code[i].b;
    const bool compares =
        code[i].op == Op::cpi && code[i].a == kX && code[i + 1].op == Op::cpc && code[i + 1].a == kX + 1;
    if (compares) end = std::max(end, static_cast<unsigned>(loaded[code[i + 1].b] << 8 | code[i].b));
  }
  return static_cast<std::uint16_t>(end);
}

void load_hex(std::string_view text, const BoardSpec& board, Firmware& firmware) {
  firmware.named = false;
  firmware.flash = read_intel_hex(text, firmware.file, board.flash_bytes, board.chip->flash_bytes);
  firmware.code_end = static_cast<std::uint32_t>(firmware.flash.size() & ~std::size_t{1});
  firmware.flash.resize((firmware.flash.size() + 1) & ~std::size_t{1}, 0xFF);
  firmware.globals_end = end_of_variables(firmware);
  firmware.ram_bytes = firmware.globals_end - firmware.chip->ram_address;
}

/// Throws InputError if the file names a chip that is not the board's. Some files name no chip.
void check_device(const ElfFile& elf, const BoardSpec& board) {
  const std::string device = avr_device(elf);
  if (device.empty() || is_same_device(device, board.chip->compiler_name)) return;
  std::string hint = fmt::format("compile it with -mmcu={}", board.chip->compiler_name);
  for (int i = 0; const BoardSpec* other = board_at(i); ++i) {
    if (!is_same_device(device, other->chip->compiler_name)) continue;
    hint = fmt::format("choose a robot with that chip, as with --robot ROBOT@{}", other->name);
    break;
  }
  throw InputError({elf.file()}, fmt::format("expected an image for the {}'s {}, got one for the {}: {}",
                                             board.name, board.chip->name, device, hint));
}

void load_elf(std::string content, const BoardSpec& board, Firmware& firmware) {
  const ElfFile elf(content_for("avr", std::move(content), firmware.file), firmware.file);
  check_program(elf);
  check_device(elf, board);
  load_symbols(elf, board, firmware);
  load_flash(elf, board, firmware);
  load_eeprom(elf, firmware);
}

}  // namespace

Firmware Firmware::read(const std::filesystem::path& file, const BoardSpec& board) {
  std::string content = read_file(file);
  Firmware firmware;
  firmware.file = file.string();
  firmware.chip = board.chip;
  firmware.last_ram = static_cast<std::uint16_t>(ram_end(*board.chip) - 1);
  if (std::string_view(board.chip->target) != "avr")
    throw InputError(
        {firmware.file},
        fmt::format("expected an image for the robot's board, the {}, got one for an AVR chip", board.name));
  if (file.extension() == ".hex") {
    load_hex(content, board, firmware);
  } else {
    load_elf(std::move(content), board, firmware);
  }
  if (firmware.code_end < 4) throw InputError({firmware.file}, "the image has no code");
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
