// Converts addresses in flash to source lines, by the DWARF debug information of the image.
//
// Uses libdw (elfutils), since a sketch's loop() is usually inlined into main(). libdw reports the place of
// the inlined call, while addr2line does not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"

struct Dwarf;
struct Elf;

namespace robosim::exec {

class DebugInfo {
 public:
  /// Opens an image. An image without debug information is valid, but the functions below find nothing in
  /// such an image.
  explicit DebugInfo(const std::filesystem::path& file);
  ~DebugInfo();
  DebugInfo(const DebugInfo&) = delete;
  DebugInfo& operator=(const DebugInfo&) = delete;

  /// Returns whether the image has debug information.
  bool is_there() const { return dwarf_ != nullptr; }
  /// Returns the function that contains the instruction at `pc`, and the functions into which that function
  /// was inlined, innermost first. Each entry has the line of the instruction or of the inlined call. The
  /// result is empty if the function is unknown.
  std::vector<SourceLine> frames(std::uint32_t pc) const;
  /// Returns the first of frames() that is in the user's code, including libraries. Returns an empty line if
  /// all frames are in core files (is_core_file()). The result is cached for each `pc`.
  const SourceLine& place(std::uint32_t pc) const;
  /// Returns the first of frames() that is in the sketch itself, not in a library.
  const SourceLine& sketch_place(std::uint32_t pc) const;

  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  /// The code of a function that belongs to no class and has no parameters.
  struct CodeOf {
    std::vector<Range> itself;
    std::vector<Range> inlined;  ///< copies of the function that were inlined into other functions
  };
  CodeOf code_of(const std::string& function) const;

  /// The location of a parameter's value when its function begins. The location is unknown if `registers` and
  /// `constant` are empty.
  struct Argument {
    std::vector<std::uint8_t> registers;  ///< DWARF's register number for each byte, from the lowest byte on
    std::optional<std::int64_t> constant;
  };
  /// The beginning of a function's own code, of a variant of the function, or of an inlined copy. The address
  /// of an inlined copy may be a few instructions after its beginning, where the arguments are known.
  struct Entry {
    std::uint32_t address = 0;
    bool is_inlined = false;
    std::vector<Argument> arguments;  ///< in the order of the declaration
  };
  std::vector<Entry> entries_of(const std::string& function) const;

  /// An address where a statement of a source line begins. A line may have several addresses, and an address
  /// may belong to several lines.
  struct CodeLine {
    std::uint32_t address = 0;
    std::string file;
    int line = 0;
  };

  /// A number, enumerator or pointer in a global or static variable of the user's code. It is the variable
  /// itself, a member or an array element.
  struct Number {
    std::uint32_t address = 0, size = 0;
    std::string path;  ///< path within the variable: "", ".left.pwm" or "[1]"
  };
  /// Returns all such numbers. Bit fields and members of unions are not included.
  std::vector<Number> numbers() const;

  /// A variable or constant of the user's code that has an address.
  struct Variable {
    std::string name;   ///< name of the variable and of the member at the address: "motors.left"
    SourceLine where;   ///< declaration of the variable
    SourceLine member;  ///< declaration of the member; empty if a constructor may set the member
  };
  /// Returns the variable that contains this address; empty if no variable is known.
  Variable variable_at(std::uint32_t address) const;

  /// Returns the addresses where lines begin, except lines of core files.
  std::vector<CodeLine> lines() const;

 private:
  template <class Wanted>
  const SourceLine& first(std::map<std::uint32_t, SourceLine>& places, std::uint32_t pc, Wanted wanted) const;

  /// The limit of the steps of all searches (dwarf_access.h). Compiled programs stay far below this limit.
  static constexpr std::int64_t kMostSteps = 20'000'000;

  std::string content_;  ///< content of the file; a confined process could not read the file later
  Elf* elf_ = nullptr;
  Dwarf* dwarf_ = nullptr;
  mutable std::int64_t steps_left_ = kMostSteps;
  mutable std::map<std::uint32_t, SourceLine> places_, sketch_places_;
};

/// Returns whether a file that debug information names does not belong to the user. Such files belong to the
/// Arduino core, the C library or Robosim.
bool is_core_file(const std::string& file);

}  // namespace robosim::exec
