#include "sim/mcu/avr/instruction_effects.h"

#include "sim/mcu/avr/instruction_table.h"

namespace robosim::avr {
namespace {

constexpr std::uint32_t one(unsigned reg) { return std::uint32_t{1} << (reg & 31u); }
constexpr std::uint32_t two(unsigned reg) { return std::uint32_t{3} << (reg & 31u); }

std::uint32_t registers_of(std::uint8_t which, const Instruction& i, const InstructionRow& row) {
  std::uint32_t all = 0;
  if (which & kRd) all |= one(i.a);
  if (which & kRr) all |= one(i.b);
  if (which & kRdPair) all |= two(i.a);
  if (which & kRrPair) all |= two(i.b);
  if (which & kR0) all |= one(0);
  if (which & kR1R0) all |= two(0);
  if (which & kPointer) all |= two(row.pointer);
  return all;
}

constexpr std::uint8_t flags_of(std::uint8_t mask, const Instruction& i) {
  return mask == kFlagOfB ? i.b : mask;
}

/// Sets the access to data memory, if there is one.
void set_memory(InstructionEffects& e, const Instruction& i, const InstructionRow& row, const Cpu& cpu) {
  const unsigned return_bytes = cpu.chip().return_address_bytes;
  const bool is_return = row.location == Location::return_address;
  int address = 0;
  switch (row.location) {
    case Location::none:
    case Location::flash:
      return;
    case Location::pointer:
      address = cpu.pair(row.pointer) + (row.step < 0 ? -1 : 0);
      break;
    case Location::displaced:
      address = cpu.pair(row.pointer) + i.b;
      break;
    case Location::address:
    case Location::io:
      address = i.k;
      break;
    case Location::stack:
      address = row.stores ? cpu.sp() : cpu.sp() + 1;
      break;
    case Location::return_address:
      address = cpu.sp() + 1 - (row.stores ? static_cast<int>(return_bytes) : 0);
      break;
  }
  e.memory = row.stores ? InstructionEffects::Memory::store : InstructionEffects::Memory::load;
  e.address = static_cast<Address>(address);
  e.bytes = static_cast<std::uint8_t>(is_return ? return_bytes : 1);
  e.touched = row.location == Location::io ? 1 : 2;
}

}  // namespace

RegisterAccess registers_of(const Instruction& i) {
  const InstructionRow& row = row_of(i.op);
  const bool clears = i.op == Op::eor && i.a == i.b;
  return {clears ? 0 : registers_of(row.reads, i, row), registers_of(row.writes, i, row)};
}

InstructionEffects effects_of(const Instruction& i, const Cpu& cpu) {
  const InstructionRow& row = row_of(i.op);
  InstructionEffects e;
  e.elsewhere = row.elsewhere;
  if (row.elsewhere) return e;
  const RegisterAccess registers = registers_of(i);
  e.reads = registers.reads;
  e.writes = registers.writes;
  e.flags_read = flags_of(row.flags_read, i);
  e.flags_written = flags_of(row.flags_written, i);
  set_memory(e, i, row, cpu);
  return e;
}

}  // namespace robosim::avr
