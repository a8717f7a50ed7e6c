// Which lines of the sketch an instruction belongs to, looked up once for each.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class SketchLines {
 public:
  using Line = const SourceLine*;  ///< the same for the same file and line, as long as this is there

  /// `debug` outlives this.
  explicit SketchLines(const DebugInfo& debug) : debug_(debug) {}

  struct Place {
    bool is_described = false;  ///< by debug information: it is no routine of the compiler's
    bool is_pause = false;      ///< it stands in delay() or micros(), which decide nothing
    std::vector<Line> lines;    ///< the sketch's, innermost first
  };
  /// `pc` in words.
  const Place& at(std::uint32_t pc) const;
  Line line(const SourceLine& where) const;
  /// The lines that declare the variable or constant at an address of the ELF file, and the member of it.
  const std::vector<Line>& declarations(std::uint32_t address) const;

 private:
  const DebugInfo& debug_;
  mutable std::map<std::pair<std::string, int>, SourceLine> lines_;
  mutable std::map<std::uint32_t, Place> places_;
  mutable std::map<std::uint32_t, std::vector<Line>> declarations_;
};

}  // namespace robosim::exec::avr
