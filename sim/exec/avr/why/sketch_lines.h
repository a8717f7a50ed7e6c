// Maps instructions to the lines of the sketch that they belong to; looks up each once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class SketchLines {
 public:
  using Line = const SourceLine*;  ///< equal for equal file and line, while this object exists

  /// `debug` outlives this.
  explicit SketchLines(const DebugInfo& debug) : debug_(debug) {}

  struct Place {
    bool is_described = false;  ///< by debug information; routines of the compiler are not
    bool is_pause = false;      ///< in delay() or micros(), which decide nothing
    std::vector<Line> lines;    ///< in the sketch, innermost first
  };
  /// `pc` in words.
  const Place& at(std::uint32_t pc) const;
  Line line(const SourceLine& where) const;
  /// Returns the lines that declare the variable or constant at an address of the ELF file, and its member.
  const std::vector<Line>& declarations(std::uint32_t address) const;

 private:
  const DebugInfo& debug_;
  mutable std::map<std::pair<std::string, int>, SourceLine> lines_;
  mutable std::map<std::uint32_t, Place> places_;
  mutable std::map<std::uint32_t, std::vector<Line>> declarations_;
};

}  // namespace robosim::exec::avr
