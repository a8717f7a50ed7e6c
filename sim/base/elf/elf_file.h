// Reads loaded segments, sections and symbols of ELF files with libelf (elfutils). Users' files may be
// damaged. Damaged files are rejected with an error message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct Elf;

namespace robosim {

/// A segment that is loaded into memory.
struct ElfSegment {
  std::uint64_t address = 0;  ///< physical address, in flash
  std::string_view bytes;     ///< content in the file; valid as long as the ElfFile
  bool code = false;
};

struct ElfSection {
  std::uint64_t address = 0;
  std::uint64_t size = 0;
  bool loaded = false;  ///< uses memory at run time
  bool writable = false;
  bool has_content = false;  ///< the file contains the section's bytes; otherwise they are zero-initialised
};

struct ElfSymbol {
  enum class Kind { function, object, file_or_section, other };
  std::string_view name;  ///< valid as long as the ElfFile
  std::uint64_t value = 0;
  std::uint64_t size = 0;
  Kind kind = Kind::other;
  bool absolute = false;  ///< has a value, but no address
};

class ElfFile {
 public:
  /// Returns whether the content begins like an ELF file, and is at least as long as an ELF header.
  static bool is_one(std::string_view content);

  /// Opens a file. Throws InputError, which names `file`, if is_one() returns false or a table lies outside
  /// the file. The other functions throw InputError for damaged parts.
  ElfFile(std::string content, std::string file);
  ElfFile(const ElfFile&) = delete;
  ElfFile& operator=(const ElfFile&) = delete;

  const std::string& file() const { return file_; }
  bool is_for_avr() const { return is_for_avr_; }
  /// Returns whether the file is a finished program, not an object file or library.
  bool is_program() const { return is_program_; }

  std::vector<ElfSegment> segments() const;
  std::vector<ElfSection> sections() const;
  /// Returns the content of the section with this name; empty if the section is missing. The content is valid
  /// as long as this object.
  std::string_view content_of(std::string_view section) const;
  /// Returns the defined symbols, in the file's order.
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
