#include "sim/sketch/elf_size.h"

#include <elf.h>

#include <cstring>

namespace robosim::sketch {
namespace {

template <typename Header, typename Section>
ElfSize add_sections(std::string_view file) {
  Header header;
  if (file.size() < sizeof header) return {};
  std::memcpy(&header, file.data(), sizeof header);
  ElfSize size;
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    const std::uint64_t at = header.e_shoff + std::uint64_t{i} * header.e_shentsize;
    if (at > file.size() || file.size() - at < sizeof(Section)) return {};
    Section section;
    std::memcpy(&section, file.data() + at, sizeof section);
    if (!(section.sh_flags & SHF_ALLOC)) continue;
    (section.sh_flags & SHF_WRITE ? size.data : size.text) += section.sh_size;
  }
  return size;
}

}  // namespace

ElfSize elf_size(std::string_view file) {
  if (file.size() < EI_NIDENT || file.substr(0, 4) != "\177ELF" || file[EI_DATA] != ELFDATA2LSB) return {};
  return file[EI_CLASS] == ELFCLASS64 ? add_sections<Elf64_Ehdr, Elf64_Shdr>(file)
                                      : add_sections<Elf32_Ehdr, Elf32_Shdr>(file);
}

}  // namespace robosim::sketch
