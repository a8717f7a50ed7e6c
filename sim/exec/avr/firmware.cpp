#include "sim/exec/avr/firmware.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/avr/registers.h"
#include "sim/exec/elf/file_reader.h"

namespace robosim::exec::avr {
namespace {

constexpr std::uint32_t kEnlargedFlash = 0x10000;  // all that a data pointer reaches

void load_segments(const FileReader& in, const Elf32_Ehdr& header, const BoardSpec& board,
                   Firmware& firmware) {
  std::vector<Elf32_Phdr> segments;
  std::uint64_t size = 0;
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    const auto segment = in.at<Elf32_Phdr>(header.e_phoff + i * std::size_t{header.e_phentsize});
    if (segment.p_type != PT_LOAD || segment.p_filesz == 0 || segment.p_paddr >= kDataSpace) continue;
    segments.push_back(segment);
    size = std::max(size, std::uint64_t{segment.p_paddr} + segment.p_filesz);
  }
  const std::uint32_t room = firmware.needs_larger_chip() ? kEnlargedFlash : board.flash_bytes;
  if (size > room) {
    throw InputError({firmware.file}, fmt::format("needs {} bytes of flash; the {} has {} for a sketch", size,
                                                  board.name, room));
  }
  firmware.flash.assign(size, 0xFF);
  for (const Elf32_Phdr& segment : segments) {
    std::memcpy(firmware.flash.data() + segment.p_paddr, in.bytes(segment.p_offset, segment.p_filesz),
                segment.p_filesz);
    if (segment.p_flags & PF_X)
      firmware.code_end = std::max(firmware.code_end, segment.p_paddr + segment.p_filesz);
  }
}

void load_symbols(const FileReader& in, const Elf32_Ehdr& header, Firmware& firmware) {
  const auto section = [&](unsigned number) {
    return in.at<Elf32_Shdr>(header.e_shoff + number * std::size_t{header.e_shentsize});
  };
  const std::uint32_t first_ram = kDataSpace + firmware.chip->ram_address;
  std::uint32_t data_end = first_ram, stack = 0;
  bool checks = false;
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    const Elf32_Shdr table = section(i);
    if (table.sh_flags & SHF_ALLOC && table.sh_addr >= kDataSpace && table.sh_addr < kEepromSpace)
      data_end = std::max(data_end, table.sh_addr + table.sh_size);
    if (table.sh_type != SHT_SYMTAB || table.sh_link >= header.e_shnum) continue;
    const Elf32_Shdr names = section(table.sh_link);
    for (std::size_t at = 0; at + sizeof(Elf32_Sym) <= table.sh_size; at += sizeof(Elf32_Sym)) {
      const auto symbol = in.at<Elf32_Sym>(table.sh_offset + at);
      const int type = ELF32_ST_TYPE(symbol.st_info);
      if (symbol.st_shndx == SHN_UNDEF || type == STT_FILE || type == STT_SECTION) continue;
      const std::string name = in.text(names.sh_offset + symbol.st_name);
      if (name == "__stack") stack = symbol.st_value;
      if (name.empty() || symbol.st_shndx == SHN_ABS) continue;
      checks |= name.starts_with(kCheckPrefix);
      firmware.symbols.add({name, symbol.st_value, symbol.st_size, symbol.st_value < kDataSpace});
    }
  }
  firmware.symbols.sort();
  if (checks && stack >= ram_end(*firmware.chip) && stack <= 0xFFFF)
    firmware.last_ram = static_cast<std::uint16_t>(stack);
  firmware.ram_bytes = data_end - first_ram;
  firmware.globals_end = static_cast<std::uint16_t>(data_end - kDataSpace);
}

}  // namespace

Firmware Firmware::read(const std::filesystem::path& file, const BoardSpec& board) {
  const std::string content = read_file(file);
  const FileReader in(content, file.string());
  Firmware firmware;
  firmware.file = file.string();
  firmware.chip = board.chip;
  firmware.last_ram = static_cast<std::uint16_t>(ram_end(*board.chip) - 1);
  if (content.size() < sizeof(Elf32_Ehdr) || std::memcmp(content.data(), ELFMAG, SELFMAG) != 0)
    throw InputError({firmware.file},
                     "is no ELF file; the target avr runs what “robosim build --target avr” makes");
  const auto header = in.at<Elf32_Ehdr>(0);
  if (header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_machine != EM_AVR || header.e_type != ET_EXEC)
    throw InputError({firmware.file}, "is an ELF file, but no program for an AVR chip");
  if (!board.chip->emulator_name)
    throw InputError({firmware.file},
                     fmt::format("is for an AVR chip, and the robot's board is the {}", board.name));
  if (header.e_phentsize != sizeof(Elf32_Phdr) ||
      (header.e_shnum > 0 && header.e_shentsize != sizeof(Elf32_Shdr)))
    in.damaged();
  load_symbols(in, header, firmware);
  load_segments(in, header, board, firmware);
  if (firmware.code_end < 4) throw InputError({firmware.file}, "holds no code");
  const std::uint32_t ram =
      firmware.needs_larger_chip() ? firmware.last_ram - board.chip->ram_address : board.ram_bytes;
  if (firmware.ram_bytes > ram) {
    throw InputError({firmware.file}, fmt::format("needs {} bytes of RAM for its variables; the {} has {}",
                                                  firmware.ram_bytes, board.name, ram));
  }
  return firmware;
}

std::optional<std::uint32_t> Firmware::find(const std::string& name) const {
  const Symbol* const symbol = symbols.find(name);
  return symbol ? std::optional(symbol->address) : std::nullopt;
}

std::optional<std::uint16_t> Firmware::find_variable(const std::string& name) const {
  const auto address = find(name);
  if (!address || *address < kDataSpace || *address >= kEepromSpace) return std::nullopt;
  return static_cast<std::uint16_t>(*address - kDataSpace);
}

std::uint32_t Firmware::loop_head(std::uint32_t entry) const {
  const Symbol* const function = function_at(entry);
  if (!function || function->address == entry || function->size == 0) return entry;
  const std::uint32_t end = std::min(function->address + function->size, code_end);
  std::uint32_t head = end;
  for (std::uint32_t pc = function->address; pc + 2 <= end;) {
    const int op = word(pc);
    const bool jmp = (op & 0xFE0E) == 0x940C, rjmp = (op & 0xF000) == 0xC000,
               branch = (op & 0xF800) == 0xF000;
    const bool two_words = jmp || (op & 0xFE0E) == 0x940E || (op & 0xFC0F) == 0x9000;
    if (two_words && pc + 4 > end) break;
    std::uint32_t target = pc + 2;
    if (jmp) target = static_cast<std::uint32_t>(word(pc + 2)) * 2;
    if (rjmp)
      target = static_cast<std::uint32_t>(static_cast<int>(pc) + 2 + 2 * (((op & 0xFFF) ^ 0x800) - 0x800));
    if (branch)
      target = static_cast<std::uint32_t>(static_cast<int>(pc) + 2 + 2 * (((op >> 3 & 0x7F) ^ 0x40) - 0x40));
    // Of all jumps back, that of the outermost loop leads furthest.
    if (pc >= entry && target <= pc && target >= function->address)
      head = std::min(head, std::max(target, entry));
    pc += two_words ? 4 : 2;
  }
  return head < end ? head : entry;
}

const Symbol* Firmware::function_at(std::uint32_t pc) const {
  return pc < code_end ? symbols.function_at(pc) : nullptr;
}

}  // namespace robosim::exec::avr
