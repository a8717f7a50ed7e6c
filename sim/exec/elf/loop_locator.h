// Finds the instructions where a round of loop() begins, for any chip.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/loop_marker.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec {

/// The part that depends on the chip: decodes the instructions of functions.
class ChipCode {
 public:
  virtual ~ChipCode() = default;
  /// Returns the addresses of the instructions that call a function, or that jump to it from another
  /// function.
  virtual std::vector<std::uint32_t> calls_of(const Symbol& function) const = 0;
  virtual Steps steps_of(const Symbol& function) const = 0;
};

/// Returns the instructions that mark the rounds of loop(). These are the calls of loop(), or the result of
/// loop_marks_of() if loop() is inlined. For a program without setup() and loop(), returns the instructions
/// that mark the rounds of the for (;;) in main().
LoopMarks locate_loop(const ChipCode& code, const Symbols& symbols, const DebugInfo& debug);

}  // namespace robosim::exec
