#include "sim/base/elf/elf_file.h"

#include <gelf.h>
#include <libelf.h>

#include <cstring>
#include <utility>

#include "sim/base/error.h"

namespace robosim {
namespace {

ElfSymbol::Kind kind_of(const GElf_Sym& symbol) {
  switch (GELF_ST_TYPE(symbol.st_info)) {
    case STT_FUNC:
      return ElfSymbol::Kind::function;
    case STT_OBJECT:
      return ElfSymbol::Kind::object;
    case STT_FILE:
    case STT_SECTION:
      return ElfSymbol::Kind::file_or_section;
    default:
      return ElfSymbol::Kind::other;
  }
}

}  // namespace

bool ElfFile::is_one(std::string_view content) {
  return content.size() >= sizeof(Elf32_Ehdr) && std::memcmp(content.data(), ELFMAG, SELFMAG) == 0;
}

ElfFile::ElfFile(std::string content, std::string file)
    : content_(std::move(content)), file_(std::move(file)) {
  if (!is_one(content_)) throw InputError({file_}, "not an ELF file");
  ::elf_version(EV_CURRENT);
  elf_.reset(::elf_memory(content_.data(), content_.size()));
  GElf_Ehdr header;
  if (!elf_ || !::gelf_getehdr(elf_.get(), &header)) damaged();
  is_for_avr_ = header.e_machine == EM_AVR;
  is_program_ = header.e_type == ET_EXEC;
  if (::elf_getshdrnum(elf_.get(), &section_count_) != 0 ||
      ::elf_getphdrnum(elf_.get(), &segment_count_) != 0)
    damaged();
  // libelf treats tables outside the file as missing.
  if (section_count_ < header.e_shnum || segment_count_ < header.e_phnum) damaged();
  const auto has_size = [&](std::size_t size, Elf_Type type) {
    return size == ::gelf_fsize(elf_.get(), type, 1, EV_CURRENT);
  };
  if (header.e_shnum > 0 && !has_size(header.e_shentsize, ELF_T_SHDR)) damaged();
  if (header.e_phnum > 0 && !has_size(header.e_phentsize, ELF_T_PHDR)) damaged();
}

void ElfFile::End::operator()(Elf* elf) const { ::elf_end(elf); }

void ElfFile::damaged() const {
  throw InputError({file_}, "the ELF file is damaged: a table or section is outside the file");
}

std::vector<ElfSegment> ElfFile::segments() const {
  std::vector<ElfSegment> found;
  for (std::size_t i = 0; i < segment_count_; ++i) {
    GElf_Phdr segment;
    if (!::gelf_getphdr(elf_.get(), static_cast<int>(i), &segment)) damaged();
    if (segment.p_type != PT_LOAD || segment.p_filesz == 0) continue;
    if (segment.p_offset > content_.size() || segment.p_filesz > content_.size() - segment.p_offset)
      damaged();
    found.push_back({segment.p_paddr, std::string_view(content_).substr(segment.p_offset, segment.p_filesz),
                     (segment.p_flags & PF_X) != 0});
  }
  return found;
}

std::vector<ElfSection> ElfFile::sections() const {
  std::vector<ElfSection> found;
  for (std::size_t i = 0; i < section_count_; ++i) {
    GElf_Shdr section;
    if (!::gelf_getshdr(::elf_getscn(elf_.get(), i), &section)) damaged();
    found.push_back({section.sh_addr, section.sh_size, (section.sh_flags & SHF_ALLOC) != 0,
                     (section.sh_flags & SHF_WRITE) != 0, section.sh_type != SHT_NOBITS});
  }
  return found;
}

std::string_view ElfFile::content_of(std::string_view name) const {
  std::size_t names = 0;
  if (::elf_getshdrstrndx(elf_.get(), &names) != 0) return {};
  for (std::size_t i = 0; i < section_count_; ++i) {
    GElf_Shdr section;
    if (!::gelf_getshdr(::elf_getscn(elf_.get(), i), &section)) damaged();
    const char* const own = ::elf_strptr(elf_.get(), names, section.sh_name);
    if (!own || own != name || section.sh_type == SHT_NOBITS) continue;
    if (section.sh_offset > content_.size() || section.sh_size > content_.size() - section.sh_offset)
      damaged();
    return std::string_view(content_).substr(section.sh_offset, section.sh_size);
  }
  return {};
}

std::vector<ElfSymbol> ElfFile::symbols() const {
  std::vector<ElfSymbol> found;
  for (std::size_t i = 0; i < section_count_; ++i) {
    Elf_Scn* const section = ::elf_getscn(elf_.get(), i);
    GElf_Shdr table;
    if (!::gelf_getshdr(section, &table)) damaged();
    if (table.sh_type != SHT_SYMTAB || table.sh_size == 0) continue;
    Elf_Data* const data = ::elf_getdata(section, nullptr);
    if (!data) damaged();
    const std::size_t count = data->d_size / ::gelf_fsize(elf_.get(), ELF_T_SYM, 1, EV_CURRENT);
    for (std::size_t k = 0; k < count; ++k) {
      GElf_Sym symbol;
      if (!::gelf_getsym(data, static_cast<int>(k), &symbol)) damaged();
      if (symbol.st_shndx == SHN_UNDEF) continue;
      const char* const name = ::elf_strptr(elf_.get(), table.sh_link, symbol.st_name);
      if (!name) damaged();
      found.push_back({name, symbol.st_value, symbol.st_size, kind_of(symbol), symbol.st_shndx == SHN_ABS});
    }
  }
  return found;
}

}  // namespace robosim
