// Decides whether a program loops forever on its own: it is followed without interrupts and peripherals until
// registers and memory repeat.
//
// A state that repeats once repeats again, unless an interrupt changes what the loop reads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/avr/cpu.h"

namespace robosim::avr {

struct InfiniteLoop {
  std::vector<bool> reads;     ///< by address in data memory, without registers
  bool interruptible = false;  ///< somewhere in it, the I flag is set
};

/// Finds the loop, within the limit of instructions. Returns nothing if the program needs more than the
/// processor, or accesses I/O registers other than SREG and SP. `cpu` does not change.
std::optional<InfiniteLoop> find_infinite_loop(const Cpu& cpu, int most_instructions);

/// The addresses in data memory that an interrupt's handler may change, without its own stack.
using Stores = std::vector<bool>;
/// Finds them. Returns nothing if its code alone does not tell: it calls, stores by a pointer or accesses
/// I/O.
std::optional<Stores> stores_of_handler(const Cpu& cpu, int vector);

}  // namespace robosim::avr
