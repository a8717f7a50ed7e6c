// Places in the sketch's source for addresses in flash, from the image's DWARF.
//
// By libdw (elfutils), inside this process: a sketch's loop() is usually inlined into main(), and libdw also
// tells where; addr2line cannot.
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
  /// An image without debug information is fine: nothing is found in it.
  explicit DebugInfo(const std::filesystem::path& file);
  ~DebugInfo();
  DebugInfo(const DebugInfo&) = delete;
  DebugInfo& operator=(const DebugInfo&) = delete;

  /// Whether the image has any.
  bool is_there() const { return dwarf_ != nullptr; }
  /// The function that holds the instruction at `pc`, and those that it was inlined into, innermost first,
  /// each with the line it has reached. Empty if not known.
  std::vector<SourceLine> frames(std::uint32_t pc) const;
  /// Of frames() the first that is the user's; empty if none is. Looked up once for each `pc`.
  const SourceLine& place(std::uint32_t pc) const;
  /// The same of the sketch itself, not of libraries.
  const SourceLine& sketch_place(std::uint32_t pc) const;

  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  /// Where the code of a function is that belongs to no class and has no parameters.
  struct CodeOf {
    std::vector<Range> itself;
    std::vector<Range> inlined;  ///< into others
  };
  CodeOf code_of(const std::string& function) const;

  /// Where a statement of a line begins: several for one line, and several lines may begin at one.
  struct CodeLine {
    std::uint32_t address = 0;
    std::string file;
    int line = 0;
  };
  /// Addresses of the user's global and static variables that are one number, enumerator or pointer each.
  std::vector<std::uint32_t> numbers() const;

  /// A variable, or constant, of the user's that has a place of its own.
  struct Variable {
    std::string name;   ///< with that of the member: "motors.left"
    SourceLine where;   ///< its declaration
    SourceLine member;  ///< that of the member, where no constructor gives it what it begins with
  };
  /// That which holds this address; empty where none is known.
  Variable variable_at(std::uint32_t address) const;

  /// But for those of core files.
  std::vector<CodeLine> lines() const;

 private:
  template <class Wanted>
  const SourceLine& first(std::map<std::uint32_t, SourceLine>& places, std::uint32_t pc, Wanted wanted) const;

  std::string content_;  ///< all of the file: nothing is read later, when the process may have no files
  Elf* elf_ = nullptr;
  Dwarf* dwarf_ = nullptr;
  mutable std::map<std::uint32_t, SourceLine> places_, sketch_places_;
};

/// Whether debug information names this file for code that is not the user's: the core, the C library,
/// Robosim.
bool is_core_file(const std::string& file);

}  // namespace robosim::exec
