// ELF files, read by libelf of elfutils: what is loaded into memory, sections and symbols. Files come from
// users and may be damaged; that is refused in a sentence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct Elf;

namespace robosim {

/// What is loaded into memory.
struct ElfSegment {
  std::uint64_t address = 0;  ///< physical: where it is flashed
  std::string_view bytes;     ///< its content in the file; valid as long as the file is
  bool code = false;
};

struct ElfSection {
  std::uint64_t address = 0;
  std::uint64_t size = 0;
  bool loaded = false;  ///< it takes memory when the program runs
  bool writable = false;
  bool has_content = false;  ///< in the file; else it begins as zeros
};

struct ElfSymbol {
  enum class Kind { function, object, file_or_section, other };
  std::string_view name;  ///< valid as long as the file is
  std::uint64_t value = 0;
  std::uint64_t size = 0;
  Kind kind = Kind::other;
  bool absolute = false;  ///< it has a value and no place
};

class ElfFile {
 public:
  /// Whether it begins as an ELF file does, and is as long as its header.
  static bool is_one(std::string_view content);

  /// Throws InputError, which names `file`, unless is_one() holds and its tables lie within it. The other
  /// functions throw it where what they are asked for is damaged.
  ElfFile(std::string content, std::string file);
  ElfFile(const ElfFile&) = delete;
  ElfFile& operator=(const ElfFile&) = delete;

  const std::string& file() const { return file_; }
  bool is_for_avr() const { return is_for_avr_; }
  /// A finished program, no object file and no library.
  bool is_program() const { return is_program_; }

  std::vector<ElfSegment> segments() const;
  std::vector<ElfSection> sections() const;
  /// What the file holds of the section of this name; empty if it has none. Valid as long as the file is.
  std::string_view content_of(std::string_view section) const;
  /// Those that are defined, in the file's order.
  std::vector<ElfSymbol> symbols() const;

 private:
  struct End {
    void operator()(Elf* elf) const;
  };
  [[noreturn]] void damaged() const;

  std::string content_;
  std::string file_;
  std::unique_ptr<Elf, End> elf_;
  bool is_for_avr_ = false, is_program_ = false;
  std::size_t section_count_ = 0, segment_count_ = 0;
};

}  // namespace robosim
