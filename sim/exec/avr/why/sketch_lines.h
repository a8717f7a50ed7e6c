// Maps instructions to source lines of the sketch, and caches the result for each instruction.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class SketchLines {
 public:
  using Line = const SourceLine*;  ///< unique for a file and line; valid while this object exists

  /// `debug` must outlive this object.
  explicit SketchLines(const DebugInfo& debug) : debug_(debug) {}

  struct Place {
    bool is_described = false;  ///< has debug information; false in routines of the compiler's library
    bool is_pause = false;      ///< in a core function that only pauses: its branches are not causes
    std::vector<Line> lines;    ///< lines in the sketch, innermost first
  };
  /// Returns the place of the instruction at word address `pc`.
  const Place& at(std::uint32_t pc) const;
  Line line(const SourceLine& where) const;
  /// Returns the line that declares the variable or constant at an ELF address. If a member is at this
  /// address, also returns the line that declares the member.
  const std::vector<Line>& declarations(std::uint32_t address) const;

 private:
  const DebugInfo& debug_;
  mutable std::map<std::pair<std::string, int>, SourceLine> lines_;
  mutable std::map<std::uint32_t, Place> places_;
  mutable std::map<std::uint32_t, std::vector<Line>> declarations_;
};

}  // namespace robosim::exec::avr
