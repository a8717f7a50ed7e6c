// Finds where a round of loop() begins, for any chip.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/loop_marker.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec {

/// The view of a chip's instructions that this needs.
class ChipCode {
 public:
  virtual ~ChipCode() = default;
  /// Returns the calls of a function, and jumps to it from elsewhere.
  virtual std::vector<std::uint32_t> calls_of(const Symbol& function) const = 0;
  virtual Steps steps_of(const Symbol& function) const = 0;
};

/// Returns the rounds of loop(): its calls, or if it is inlined, the result of loop_marks_of(). For a program
/// without setup() and loop(), those of the for (;;) in main().
LoopMarks locate_loop(const ChipCode& code, const Symbols& symbols, const DebugInfo& debug);

}  // namespace robosim::exec
