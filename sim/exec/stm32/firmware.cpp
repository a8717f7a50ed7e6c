#include "sim/exec/stm32/firmware.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/elf/file_reader.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

void load_segment(const FileReader& in, const Elf32_Phdr& segment, const BoardSpec& board,
                  Firmware& firmware) {
  const std::uint64_t end = std::uint64_t{segment.p_paddr} + segment.p_filesz;
  if (segment.p_paddr < kFlash || end > kFlash + kFlashBytes) {
    throw InputError(
        {firmware.file},
        fmt::format("has something for address 0x{:08X}, where the {} has no flash: it is not linked "
                    "for its chip",
                    segment.p_paddr, board.name));
  }
  if (end > kFlash + board.flash_bytes) {
    throw InputError({firmware.file}, fmt::format("needs {} bytes of flash; the {} has {} for a sketch",
                                                  end - kFlash, board.name, board.flash_bytes));
  }
  std::memcpy(firmware.flash.data() + (segment.p_paddr - kFlash),
              in.bytes(segment.p_offset, segment.p_filesz), segment.p_filesz);
  firmware.flash_bytes = std::max(firmware.flash_bytes, static_cast<std::uint32_t>(end - kFlash));
  if (segment.p_flags & PF_X)
    firmware.code_end = std::max(firmware.code_end, static_cast<std::uint32_t>(end));
}

bool is_variables(const Elf32_Shdr& section) {
  return section.sh_flags & SHF_ALLOC && section.sh_addr >= kRam && section.sh_addr < kRam + kRamBytes &&
         section.sh_size > 0;
}

void load_symbols(const FileReader& in, const Elf32_Ehdr& header, Firmware& firmware) {
  const auto section = [&](unsigned number) {
    return in.at<Elf32_Shdr>(header.e_shoff + number * std::size_t{header.e_shentsize});
  };
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    const Elf32_Shdr table = section(i);
    if (is_variables(table))
      firmware.globals_end = std::max(firmware.globals_end, table.sh_addr + table.sh_size);
    if (table.sh_type != SHT_SYMTAB || table.sh_link >= header.e_shnum) continue;
    const Elf32_Shdr names = section(table.sh_link);
    for (std::size_t at = 0; at + sizeof(Elf32_Sym) <= table.sh_size; at += sizeof(Elf32_Sym)) {
      const auto symbol = in.at<Elf32_Sym>(table.sh_offset + at);
      const int type = ELF32_ST_TYPE(symbol.st_info);
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx == SHN_ABS ||
          (type != STT_FUNC && type != STT_OBJECT))
        continue;
      // A function's lowest bit says Thumb.
      const bool code = type == STT_FUNC;
      firmware.symbols.add({in.text(names.sh_offset + symbol.st_name),
                            code ? symbol.st_value & ~1u : symbol.st_value, symbol.st_size, code});
    }
  }
  firmware.symbols.sort();
}

}  // namespace

Firmware Firmware::read(const std::filesystem::path& file, const BoardSpec& board) {
  const std::string content = read_file(file);
  const FileReader in(content, file.string());
  Firmware firmware;
  firmware.file = file.string();
  firmware.flash.assign(kFlashBytes, 0xFF);
  firmware.globals_end = kRam;
  firmware.code_end = kFlash;
  if (content.size() < sizeof(Elf32_Ehdr) || std::memcmp(content.data(), ELFMAG, SELFMAG) != 0)
    throw InputError({firmware.file},
                     "is no ELF file; the target stm32 runs what “robosim build --target stm32” makes");
  const auto header = in.at<Elf32_Ehdr>(0);
  if (header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_machine != EM_ARM || header.e_type != ET_EXEC)
    throw InputError({firmware.file}, "is an ELF file, but no program for an ARM microcontroller");
  if (header.e_phentsize != sizeof(Elf32_Phdr) ||
      (header.e_shnum > 0 && header.e_shentsize != sizeof(Elf32_Shdr)))
    in.damaged();
  if (std::string_view(board.chip->name) != kStm32f103c8.name)
    throw InputError({firmware.file},
                     fmt::format("is for a Blue Pill, and the robot's board is the {}", board.name));
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    const auto segment = in.at<Elf32_Phdr>(header.e_phoff + i * std::size_t{header.e_phentsize});
    if (segment.p_type == PT_LOAD && segment.p_filesz > 0) load_segment(in, segment, board, firmware);
  }
  load_symbols(in, header, firmware);
  if (firmware.flash_bytes < 64 * 4) throw InputError({firmware.file}, "holds no code");
  firmware.ram_bytes = firmware.globals_end - kRam;
  return firmware;
}

}  // namespace robosim::exec::stm32
