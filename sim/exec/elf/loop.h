// Where a round of loop() begins, whatever the chip.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/rounds.h"
#include "sim/exec/elf/symbols.h"

namespace robosim::exec {

/// What a chip's instructions are, as far as that matters here.
class ChipCode {
 public:
  virtual ~ChipCode() = default;
  /// Calls of a function, and jumps to it from elsewhere.
  virtual std::vector<std::uint32_t> calls_of(const Symbol& function) const = 0;
  virtual Steps steps_of(const Symbol& function) const = 0;
};

/// The rounds of loop(): its calls, or where it is inlined what rounds_of() finds. Of a program without
/// setup() and loop(), those of the for (;;) in main().
Rounds rounds_of_loop(const ChipCode& code, const Symbols& symbols, const DebugInfo& debug);

}  // namespace robosim::exec
