// Decides whether a program is in an infinite loop. Runs the program without interrupts and peripherals until
// registers and memory repeat.
//
// Once a state has repeated, the loop runs forever, unless an interrupt changes memory that the loop reads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {

struct InfiniteLoop {
  std::vector<bool> reads;     ///< by data address: the loop reads the byte; false for registers
  bool interruptible = false;  ///< the I flag is set somewhere in the loop
};

/// Finds the loop within at most `most_instructions` instructions. Returns nothing if the program depends on
/// more than the processor, or accesses I/O registers other than SREG and SP. `cpu` does not change.
std::optional<InfiniteLoop> find_infinite_loop(const Cpu& cpu, int most_instructions);

/// For each address in data memory: whether an interrupt handler may change the byte. Excludes the handler's
/// stack.
using Stores = std::vector<bool>;
/// Finds the addresses that a handler may change. Returns nothing if the code does not determine them: the
/// handler calls functions, accesses memory through pointers, or accesses I/O.
std::optional<Stores> stores_of_handler(const Cpu& cpu, int vector);

}  // namespace robosim::avr
