// Converts addresses in flash to places in the sketch's source, from the image's DWARF.
//
// Uses libdw (elfutils) inside this process. A sketch's loop() is usually inlined into main(), and libdw also
// reports where; addr2line cannot.
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
  /// Opens an image. One without debug information is valid: nothing is found in it.
  explicit DebugInfo(const std::filesystem::path& file);
  ~DebugInfo();
  DebugInfo(const DebugInfo&) = delete;
  DebugInfo& operator=(const DebugInfo&) = delete;

  /// Returns whether the image has debug information.
  bool is_there() const { return dwarf_ != nullptr; }
  /// Returns the function that holds the instruction at `pc`, and those that it was inlined into, innermost
  /// first. Each has the line that it has reached. Empty if unknown.
  std::vector<SourceLine> frames(std::uint32_t pc) const;
  /// Returns the first of frames() that is the user's; empty if none is. Looked up once for each `pc`.
  const SourceLine& place(std::uint32_t pc) const;
  /// Returns the first of frames() in the sketch itself, not in libraries.
  const SourceLine& sketch_place(std::uint32_t pc) const;

  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  /// Places of the code of a function that belongs to no class and has no parameters.
  struct CodeOf {
    std::vector<Range> itself;
    std::vector<Range> inlined;  ///< into others
  };
  CodeOf code_of(const std::string& function) const;

  /// A place where a statement of a line begins. A line can have several, and several lines can begin at one.
  struct CodeLine {
    std::uint32_t address = 0;
    std::string file;
    int line = 0;
  };
  /// Returns the addresses of the user's global and static variables that are one number, enumerator or
  /// pointer each.
  std::vector<std::uint32_t> numbers() const;

  /// A variable or constant of the user's code with its own address.
  struct Variable {
    std::string name;   ///< including the member: "motors.left"
    SourceLine where;   ///< its declaration
    SourceLine member;  ///< the declaration of the member, if no constructor initialises it
  };
  /// Returns the variable that holds this address; empty if none is known.
  Variable variable_at(std::uint32_t address) const;

  /// Returns the lines, except those of core files.
  std::vector<CodeLine> lines() const;

 private:
  template <class Wanted>
  const SourceLine& first(std::map<std::uint32_t, SourceLine>& places, std::uint32_t pc, Wanted wanted) const;

  std::string content_;  ///< all of the file: nothing is read later, when file access may be denied
  Elf* elf_ = nullptr;
  Dwarf* dwarf_ = nullptr;
  mutable std::map<std::uint32_t, SourceLine> places_, sketch_places_;
};

/// Returns whether this file, named by debug information, is not the user's: core, C library, Robosim.
bool is_core_file(const std::string& file);

}  // namespace robosim::exec
