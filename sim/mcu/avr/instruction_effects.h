// Predicts an instruction's accesses before the instruction runs, for observers of a running program.
// instruction_table.h lists the accesses of each operation.
#pragma once

#include <bit>
#include <cstdint>

#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {

struct InstructionEffects {
  enum class Memory : std::uint8_t { none, load, store };

  std::uint32_t reads = 0, writes = 0;  ///< registers, one bit each
  std::uint8_t flags_read = 0, flags_written = 0;
  Memory memory = Memory::none;
  Address address = 0;       ///< lowest accessed address in data memory
  std::uint8_t bytes = 0;    ///< number of accessed bytes in data memory
  std::uint8_t touched = 0;  ///< cycles from the instruction's start to the access
  bool elsewhere = false;    ///< affects more than registers, flags and data memory
};

/// Calls `visit` with the number of each register whose bit is set in `registers`.
template <typename Visit>
void each(std::uint32_t registers, Visit visit) {
  for (; registers; registers &= registers - 1) visit(static_cast<unsigned>(std::countr_zero(registers)));
}

/// Registers that an instruction accesses, one bit each.
struct RegisterAccess {
  std::uint32_t reads = 0, writes = 0;
};
RegisterAccess registers_of(const Instruction& instruction);

/// Returns the effects of the instruction that `cpu` would run next. Accesses to the addresses of SREG and
/// the stack pointer count as data memory. The result does not include how calls and pushes change the stack
/// pointer.
InstructionEffects effects_of(const Instruction& instruction, const Cpu& cpu);

}  // namespace robosim::avr
