// Maps instructions to their lines in the sketch; looks up each instruction once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class SketchLines {
 public:
  using Line = const SourceLine*;  ///< equal pointers for equal file and line, while this object exists

  /// `debug` must outlive this object.
  explicit SketchLines(const DebugInfo& debug) : debug_(debug) {}

  struct Place {
    bool is_described = false;  ///< has debug information, unlike compiler routines
    bool is_pause = false;      ///< in delay() or micros(), whose branches decide nothing
    std::vector<Line> lines;    ///< lines in the sketch, innermost first
  };
  /// Returns the place of the instruction at word address `pc`.
  const Place& at(std::uint32_t pc) const;
  Line line(const SourceLine& where) const;
  /// Returns the lines that declare what is at an ELF address: the variable or constant, and its member.
  const std::vector<Line>& declarations(std::uint32_t address) const;

 private:
  const DebugInfo& debug_;
  mutable std::map<std::pair<std::string, int>, SourceLine> lines_;
  mutable std::map<std::uint32_t, Place> places_;
  mutable std::map<std::uint32_t, std::vector<Line>> declarations_;
};

}  // namespace robosim::exec::avr
