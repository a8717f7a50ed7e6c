// Finds the instructions where a round of loop() begins, for any chip.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/loop_marker.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec {

/// The chip-specific part: decodes the instructions of functions.
class ChipCode {
 public:
  virtual ~ChipCode() = default;
  /// Returns the addresses of calls of a function, and of jumps to it from other functions.
  virtual std::vector<std::uint32_t> calls_of(const Symbol& function) const = 0;
  virtual Steps steps_of(const Symbol& function) const = 0;
};

/// Returns the beginnings of loop()'s rounds: its calls, or loop_marks_of() if loop() is inlined. For a
/// program without setup() and loop(), returns the beginnings of the rounds of the for (;;) in main().
LoopMarks locate_loop(const ChipCode& code, const Symbols& symbols, const DebugInfo& debug);

}  // namespace robosim::exec
