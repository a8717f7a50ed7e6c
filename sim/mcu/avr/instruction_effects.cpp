#include "sim/mcu/avr/instruction_effects.h"

#include "sim/mcu/avr/instruction_table.h"

namespace robosim::avr {
namespace {

/// The registers of an operation. In each number, the lower 32 bits are the registers that the operation
/// reads. The upper 32 bits are the registers that the operation writes.
struct RegisterMasks {
  std::uint64_t always = 0;
  std::uint64_t a = 0, b = 0;  ///< `a` must be shifted by Instruction::a, and `b` by Instruction::b
};

constexpr RegisterMasks masks_of(const InstructionRow& row) {
  RegisterMasks masks;
  const auto add = [&](std::uint8_t operands, int place) {
    const auto if_has = [&](std::uint8_t operand, std::uint64_t mask) {
      return operands & operand ? mask << place : 0;
    };
    masks.a |= if_has(kRd, 1) | if_has(kRdPair, 3);
    masks.b |= if_has(kRr, 1) | if_has(kRrPair, 3);
    masks.always |= if_has(kR0, 1) | if_has(kR1R0, 3) | if_has(kPointer, std::uint64_t{3} << row.pointer);
  };
  add(row.reads, 0);
  add(row.writes, 32);
  return masks;
}

constexpr auto kMasksByOp = [] {
  std::array<RegisterMasks, table::kByOp.size()> masks;
  for (std::size_t i = 0; i < masks.size(); ++i) masks[i] = masks_of(table::kByOp[i]);
  return masks;
}();

constexpr std::uint8_t flags_of(std::uint8_t mask, const Instruction& i) {
  return mask == kFlagOfB ? i.b : mask;
}

/// Sets the access to data memory, if the instruction has one.
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
  const RegisterMasks& masks = kMasksByOp[static_cast<std::size_t>(i.op)];
  const std::uint64_t all = masks.always | (masks.a << (i.a & 31u)) | (masks.b << (i.b & 31u));
  const bool clears = i.op == Op::eor && i.a == i.b;
  return {clears ? 0 : static_cast<std::uint32_t>(all), static_cast<std::uint32_t>(all >> 32)};
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
