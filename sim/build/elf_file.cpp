#include "sim/build/elf_file.h"

#include <elf.h>

#include <algorithm>
#include <cstring>

namespace robosim::build {
namespace {

// avr-gcc puts data memory at 0x800000, and what is neither flash nor RAM (EEPROM, fuses, lock bits,
// signature) from here on.
constexpr std::uint64_t kAvrBeyondData = 0x810000;

/// The record at `at`; false if the file ends before it does.
template <typename Record>
bool read(std::string_view file, std::uint64_t at, Record& record) {
  if (at > file.size() || file.size() - at < sizeof record) return false;
  std::memcpy(&record, file.data() + at, sizeof record);
  return true;
}

struct Elf32 {
  using Header = Elf32_Ehdr;
  using Section = Elf32_Shdr;
  using Symbol = Elf32_Sym;
};
struct Elf64 {
  using Header = Elf64_Ehdr;
  using Section = Elf64_Shdr;
  using Symbol = Elf64_Sym;
};

template <typename Elf>
std::vector<typename Elf::Section> sections(std::string_view file, const typename Elf::Header& header) {
  std::vector<typename Elf::Section> all;
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    typename Elf::Section section;
    if (!read(file, header.e_shoff + std::uint64_t{i} * header.e_shentsize, section)) return {};
    all.push_back(section);
  }
  return all;
}

template <typename Elf>
ElfSize add_sections(std::string_view file) {
  typename Elf::Header header;
  if (!read(file, 0, header)) return {};
  ElfSize size;
  for (const auto& section : sections<Elf>(file, header)) {
    if (!(section.sh_flags & SHF_ALLOC)) continue;
    if (header.e_machine == EM_AVR && section.sh_addr >= kAvrBeyondData) continue;
    (section.sh_flags & SHF_WRITE ? size.data : size.text) += section.sh_size;
    if (section.sh_flags & SHF_WRITE && section.sh_type != SHT_NOBITS) size.initialised += section.sh_size;
  }
  return size;
}

std::string_view text_at(std::string_view file, std::uint64_t at) {
  if (at >= file.size()) return {};
  const std::string_view rest = file.substr(at);
  return rest.substr(0, rest.find('\0'));
}

template <typename Elf>
std::vector<AbsoluteSymbol> find_absolute(std::string_view file, std::string_view prefix) {
  typename Elf::Header header;
  if (!read(file, 0, header)) return {};
  const auto all = sections<Elf>(file, header);
  std::vector<AbsoluteSymbol> found;
  for (const auto& table : all) {
    if (table.sh_type != SHT_SYMTAB || table.sh_link >= all.size()) continue;
    typename Elf::Symbol symbol;
    for (std::uint64_t at = 0; at < table.sh_size && read(file, table.sh_offset + at, symbol);
         at += sizeof symbol) {
      const std::string_view name = text_at(file, all[table.sh_link].sh_offset + symbol.st_name);
      if (symbol.st_shndx == SHN_ABS && name.substr(0, prefix.size()) == prefix)
        found.push_back({std::string(name), symbol.st_value});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const AbsoluteSymbol& a, const AbsoluteSymbol& b) { return a.name < b.name; });
  return found;
}

bool is_little_endian_elf(std::string_view file) {
  return file.size() >= EI_NIDENT && file.substr(0, 4) == "\177ELF" && file[EI_DATA] == ELFDATA2LSB;
}

}  // namespace

ElfSize elf_size(std::string_view file) {
  if (!is_little_endian_elf(file)) return {};
  return file[EI_CLASS] == ELFCLASS64 ? add_sections<Elf64>(file) : add_sections<Elf32>(file);
}

std::vector<AbsoluteSymbol> absolute_symbols(std::string_view file, std::string_view prefix) {
  if (!is_little_endian_elf(file)) return {};
  return file[EI_CLASS] == ELFCLASS64 ? find_absolute<Elf64>(file, prefix)
                                      : find_absolute<Elf32>(file, prefix);
}

}  // namespace robosim::build
