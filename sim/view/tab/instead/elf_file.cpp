// Reads ELF files without libelf. Supports 32-bit little-endian files, such as those for an AVR.
// target_of_elf() has rejected other files before.
#include "sim/base/elf/elf_file.h"

#include <elf.h>

#include <cstring>
#include <optional>
#include <utility>

#include "sim/base/error.h"

struct Elf {
  Elf32_Ehdr header{};
};

namespace robosim {
namespace {

/// Reads a record; returns nullopt if the file ends too early.
template <class Record>
std::optional<Record> record_at(std::string_view content, std::uint64_t offset) {
  if (offset > content.size() || content.size() - offset < sizeof(Record)) return std::nullopt;
  Record record;
  std::memcpy(&record, content.data() + offset, sizeof record);
  return record;
}

std::optional<std::string_view> part_of(std::string_view content, std::uint64_t offset, std::uint64_t size) {
  if (offset > content.size() || size > content.size() - offset) return std::nullopt;
  return content.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

/// Returns the text at an offset; nullopt if it is not terminated.
std::optional<std::string_view> text_at(std::string_view names, std::uint64_t offset) {
  const std::size_t end =
      offset < names.size() ? names.find('\0', static_cast<std::size_t>(offset)) : names.npos;
  if (end == names.npos) return std::nullopt;
  return names.substr(static_cast<std::size_t>(offset), end - static_cast<std::size_t>(offset));
}

std::optional<Elf32_Shdr> section_at(std::string_view content, const Elf32_Ehdr& header, std::size_t index) {
  return record_at<Elf32_Shdr>(content, header.e_shoff + std::uint64_t{index} * sizeof(Elf32_Shdr));
}

/// Returns the content of a section of names.
std::optional<std::string_view> names_in(std::string_view content, const Elf32_Ehdr& header,
                                         std::size_t index) {
  const auto section = index < header.e_shnum ? section_at(content, header, index) : std::nullopt;
  if (!section || section->sh_type != SHT_STRTAB) return std::nullopt;
  return part_of(content, section->sh_offset, section->sh_size);
}

ElfSymbol::Kind kind_of(const Elf32_Sym& symbol) {
  switch (ELF32_ST_TYPE(symbol.st_info)) {
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
  elf_.reset(new Elf{*record_at<Elf32_Ehdr>(content_, 0)});
  const Elf32_Ehdr& header = elf_->header;
  is_for_avr_ = header.e_machine == EM_AVR;
  is_program_ = header.e_type == ET_EXEC;
  section_count_ = header.e_shnum;
  segment_count_ = header.e_phnum;
  if (header.e_shnum > 0 && header.e_shentsize != sizeof(Elf32_Shdr)) damaged();
  if (header.e_phnum > 0 && header.e_phentsize != sizeof(Elf32_Phdr)) damaged();
  if (!part_of(content_, header.e_shoff, section_count_ * sizeof(Elf32_Shdr))) damaged();
  if (!part_of(content_, header.e_phoff, segment_count_ * sizeof(Elf32_Phdr))) damaged();
}

void ElfFile::End::operator()(Elf* elf) const { delete elf; }

void ElfFile::damaged() const {
  throw InputError({file_}, "the ELF file is damaged: a table or section is outside the file");
}

std::vector<ElfSegment> ElfFile::segments() const {
  std::vector<ElfSegment> found;
  for (std::size_t i = 0; i < segment_count_; ++i) {
    const auto segment = record_at<Elf32_Phdr>(content_, elf_->header.e_phoff + i * sizeof(Elf32_Phdr));
    if (!segment) damaged();
    if (segment->p_type != PT_LOAD || segment->p_filesz == 0) continue;
    const auto bytes = part_of(content_, segment->p_offset, segment->p_filesz);
    if (!bytes) damaged();
    found.push_back({segment->p_paddr, *bytes, (segment->p_flags & PF_X) != 0});
  }
  return found;
}

std::vector<ElfSection> ElfFile::sections() const {
  std::vector<ElfSection> found;
  for (std::size_t i = 0; i < section_count_; ++i) {
    const auto section = section_at(content_, elf_->header, i);
    if (!section) damaged();
    found.push_back({section->sh_addr, section->sh_size, (section->sh_flags & SHF_ALLOC) != 0,
                     (section->sh_flags & SHF_WRITE) != 0, section->sh_type != SHT_NOBITS});
  }
  return found;
}

std::string_view ElfFile::content_of(std::string_view name) const {
  const auto names = names_in(content_, elf_->header, elf_->header.e_shstrndx);
  for (std::size_t i = 0; names && i < section_count_; ++i) {
    const auto section = section_at(content_, elf_->header, i);
    if (!section) damaged();
    if (text_at(*names, section->sh_name) != name || section->sh_type == SHT_NOBITS) continue;
    const auto bytes = part_of(content_, section->sh_offset, section->sh_size);
    if (!bytes) damaged();
    return *bytes;
  }
  return {};
}

std::vector<ElfSymbol> ElfFile::symbols() const {
  std::vector<ElfSymbol> found;
  for (std::size_t i = 0; i < section_count_; ++i) {
    const auto table = section_at(content_, elf_->header, i);
    if (!table) damaged();
    if (table->sh_type != SHT_SYMTAB || table->sh_size == 0) continue;
    const auto names = names_in(content_, elf_->header, table->sh_link);
    const auto records = part_of(content_, table->sh_offset, table->sh_size);
    if (!names || !records || table->sh_flags & SHF_COMPRESSED) damaged();
    for (std::size_t at = 0; at + sizeof(Elf32_Sym) <= records->size(); at += sizeof(Elf32_Sym)) {
      const auto symbol = *record_at<Elf32_Sym>(*records, at);
      if (symbol.st_shndx == SHN_UNDEF) continue;
      const auto name = text_at(*names, symbol.st_name);
      if (!name) damaged();
      found.push_back({*name, symbol.st_value, symbol.st_size, kind_of(symbol), symbol.st_shndx == SHN_ABS});
    }
  }
  return found;
}

}  // namespace robosim
