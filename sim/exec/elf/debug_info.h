// Converts addresses in flash to places in the sketch's source, from the image's DWARF.
//
// Uses libdw (elfutils), since a sketch's loop() is usually inlined into main(). libdw reports the place of
// the call; addr2line does not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"

struct Dwarf;
struct Elf;

namespace robosim::exec {

class DebugInfo {
 public:
  /// Opens an image. An image without debug information is valid, but all searches in it find nothing.
  explicit DebugInfo(const std::filesystem::path& file);
  ~DebugInfo();
  DebugInfo(const DebugInfo&) = delete;
  DebugInfo& operator=(const DebugInfo&) = delete;

  /// Returns whether the image has debug information.
  bool is_there() const { return dwarf_ != nullptr; }
  /// Returns the function that contains the instruction at `pc`, and the functions into which it was inlined,
  /// innermost first. Each entry has the line that was reached. Empty if unknown.
  std::vector<SourceLine> frames(std::uint32_t pc) const;
  /// Returns the first of frames() in the user's code; empty without one. The result is cached for each
  /// `pc`.
  const SourceLine& place(std::uint32_t pc) const;
  /// Returns the first of frames() in the sketch itself, excluding libraries.
  const SourceLine& sketch_place(std::uint32_t pc) const;

  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  /// The code of a function that belongs to no class and has no parameters.
  struct CodeOf {
    std::vector<Range> itself;
    std::vector<Range> inlined;  ///< its copies in other functions
  };
  CodeOf code_of(const std::string& function) const;

  /// An address where a statement of a line begins. A line may have several addresses, and an address several
  /// lines.
  struct CodeLine {
    std::uint32_t address = 0;
    std::string file;
    int line = 0;
  };
  /// Returns the addresses of the user's global and static variables whose value is a single number,
  /// enumerator or pointer.
  std::vector<std::uint32_t> numbers() const;

  /// A variable or constant of the user's code that has an address.
  struct Variable {
    std::string name;   ///< its name, including the member: "motors.left"
    SourceLine where;   ///< its declaration
    SourceLine member;  ///< declaration of the member, if no constructor initialises it
  };
  /// Returns the variable that contains this address; empty if none is known.
  Variable variable_at(std::uint32_t address) const;

  /// Returns the addresses where lines begin, except lines of core files.
  std::vector<CodeLine> lines() const;

 private:
  template <class Wanted>
  const SourceLine& first(std::map<std::uint32_t, SourceLine>& places, std::uint32_t pc, Wanted wanted) const;

  std::string content_;  ///< the whole file, since later reads may be denied
  Elf* elf_ = nullptr;
  Dwarf* dwarf_ = nullptr;
  mutable std::map<std::uint32_t, SourceLine> places_, sketch_places_;
};

/// Returns whether a file named by debug information belongs to the core, the C library or Robosim, not to
/// the user.
bool is_core_file(const std::string& file);

}  // namespace robosim::exec
