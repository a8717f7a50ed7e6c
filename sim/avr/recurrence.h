// Whether a program goes round for ever, as far as it knows: followed by itself, without interrupts and
// peripherals, until registers and memory are once more what they were.
//
// What comes round once comes round again, unless an interrupt changes what the round reads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/avr/cpu.h"

namespace robosim::avr {

struct Round {
  std::vector<bool> reads;     ///< by address in data memory, registers left out
  bool interruptible = false;  ///< somewhere in it, the I flag is set
};

/// Nothing where the program touches a register of I/O other than SREG and SP, does what a processor cannot
/// do alone, or has not come round within so many instructions. `cpu` stays as it is.
std::optional<Round> find_round(const Cpu& cpu, int most_instructions);

/// What the handler of an interrupt may change in data memory, its own stack aside; by address.
using Stores = std::vector<bool>;
/// Nothing where that cannot be told from its code alone: it calls, stores by a pointer or touches I/O.
std::optional<Stores> stores_of_handler(const Cpu& cpu, int vector);

}  // namespace robosim::avr
