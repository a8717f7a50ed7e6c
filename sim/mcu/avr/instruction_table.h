// Lists the instruction set: for each operation, the next instruction, and the accesses to registers, flags,
// data memory and flash. Source: AVR Instruction Set Manual, DS40002198B. cpu_run.cpp and cpu_steps.h
// implement the effects on values.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "sim/mcu/avr/cpu.h"
#include "sim/mcu/avr/decode.h"

namespace robosim::avr {

/// How the processor continues after an instruction.
enum class Control : std::uint8_t {
  straight,       ///< with the following instruction
  jump,           ///< at the target
  branch,         ///< at the target, or with the following instruction
  skip,           ///< with the following instruction, or with the instruction after that
  call,           ///< at the target, and later with the following instruction
  indirect_jump,  ///< at an address in Z
  indirect_call,
  returns,  ///< at an address from the stack
  stops     ///< sleeps, or is not an instruction
};

/// The registers that an operation accesses; several values can be combined.
enum RegisterOperand : std::uint8_t {
  kNoRegister = 0,
  kRd = 1,      ///< Instruction::a
  kRr = 2,      ///< Instruction::b
  kRdPair = 4,  ///< Instruction::a and the next register
  kRrPair = 8,  ///< Instruction::b and the next register
  kR0 = 16,
  kR1R0 = 32,
  kPointer = 64  ///< the pair InstructionRow::pointer
};

/// The location that an instruction accesses.
enum class Location : std::uint8_t {
  none,
  pointer,    ///< data memory at the pointer, after it was decremented or before it is incremented
  displaced,  ///< data memory at the pointer + Instruction::b
  address,    ///< data memory at Instruction::k
  io,         ///< data memory at Instruction::k, accessed in the instruction's first cycle
  stack,      ///< a byte on the stack
  return_address,
  flash  ///< flash at Z
};

/// A placeholder in a mask of flags: the actual mask is Instruction::b.
inline constexpr std::uint8_t kFlagOfB = 0xFF;

struct InstructionRow {
  Control control = Control::straight;
  std::uint8_t reads = kNoRegister, writes = kNoRegister;
  std::uint8_t flags_read = 0, flags_written = 0;
  Location location = Location::none;
  bool stores = false;       ///< if false, the operation loads
  std::uint8_t pointer = 0;  ///< lower register of X, Y or Z
  std::int8_t step = 0;      ///< change of the pointer
  bool elsewhere = false;    ///< affects more than registers, flags and data memory
};

namespace table {

using enum Control;
using enum Location;
inline constexpr std::uint8_t kX = 26, kY = 28, kZ = 30;
inline constexpr std::uint8_t kC = Cpu::kC, kCZ = Cpu::kC | Cpu::kZ, kT = Cpu::kT;
inline constexpr std::uint8_t kSigns = Cpu::kZ | Cpu::kN | Cpu::kV | Cpu::kS, kShifts = kSigns | kC,
                              kAll = kShifts | Cpu::kH;

constexpr InstructionRow computes(int reads, int writes, int flags_written, int flags_read = 0) {
  return {.reads = static_cast<std::uint8_t>(reads),
          .writes = static_cast<std::uint8_t>(writes),
          .flags_read = static_cast<std::uint8_t>(flags_read),
          .flags_written = static_cast<std::uint8_t>(flags_written)};
}
/// Returns the row of an operation that accesses memory. If `pointer` is not 0, this register pair contains
/// the address, and the operation changes the pair by `step`.
constexpr InstructionRow accesses(int reads, int writes, Location location, bool stores, std::uint8_t pointer,
                                  int step) {
  InstructionRow row = computes(reads | (pointer ? kPointer : 0), writes | (step ? kPointer : 0), 0);
  row.location = location;
  row.stores = stores;
  row.pointer = pointer;
  row.step = static_cast<std::int8_t>(step);
  return row;
}
constexpr InstructionRow loads(Location location, std::uint8_t pointer = 0, int step = 0) {
  return accesses(0, kRd, location, false, pointer, step);
}
constexpr InstructionRow stores(Location location, std::uint8_t pointer = 0, int step = 0) {
  return accesses(kRd, 0, location, true, pointer, step);
}
constexpr InstructionRow reads_flash(int into, int step = 0) {
  return accesses(0, into, flash, false, kZ, step);
}
constexpr InstructionRow continues(Control control, int reads = 0, int flags_read = 0) {
  InstructionRow row = computes(reads, 0, 0, flags_read);
  row.control = control;
  row.pointer = kZ;
  if (control == call || control == indirect_call || control == returns) row.location = return_address;
  row.stores = control == call || control == indirect_call;
  return row;
}
constexpr InstructionRow accesses_io_bit(bool stores, Control control) {
  InstructionRow row = accesses(0, 0, io, stores, 0, 0);
  row.control = control;
  return row;
}
constexpr InstructionRow elsewhere(InstructionRow row) {
  row.elsewhere = true;
  return row;
}

struct NamedRow {
  Op op;
  InstructionRow row;
};

inline constexpr NamedRow kRows[] = {
    // two registers: reads, writes, flags written, flags read
    {Op::add, computes(kRd | kRr, kRd, kAll)},
    {Op::adc, computes(kRd | kRr, kRd, kAll, kC)},
    {Op::sub, computes(kRd | kRr, kRd, kAll)},
    {Op::sbc, computes(kRd | kRr, kRd, kAll, kCZ)},
    {Op::and_, computes(kRd | kRr, kRd, kSigns)},
    {Op::or_, computes(kRd | kRr, kRd, kSigns)},
    {Op::eor, computes(kRd | kRr, kRd, kSigns)},
    {Op::mov, computes(kRr, kRd, 0)},
    {Op::movw, computes(kRrPair, kRdPair, 0)},
    {Op::cp, computes(kRd | kRr, 0, kAll)},
    {Op::cpc, computes(kRd | kRr, 0, kAll, kCZ)},
    {Op::mul, computes(kRd | kRr, kR1R0, kCZ)},
    {Op::muls, computes(kRd | kRr, kR1R0, kCZ)},
    {Op::mulsu, computes(kRd | kRr, kR1R0, kCZ)},
    {Op::fmul, computes(kRd | kRr, kR1R0, kCZ)},
    {Op::fmuls, computes(kRd | kRr, kR1R0, kCZ)},
    {Op::fmulsu, computes(kRd | kRr, kR1R0, kCZ)},
    // a register and a constant
    {Op::subi, computes(kRd, kRd, kAll)},
    {Op::sbci, computes(kRd, kRd, kAll, kCZ)},
    {Op::andi, computes(kRd, kRd, kSigns)},
    {Op::ori, computes(kRd, kRd, kSigns)},
    {Op::ldi, computes(0, kRd, 0)},
    {Op::cpi, computes(kRd, 0, kAll)},
    {Op::adiw, computes(kRdPair, kRdPair, kShifts)},
    {Op::sbiw, computes(kRdPair, kRdPair, kShifts)},
    // a register
    {Op::com, computes(kRd, kRd, kShifts)},
    {Op::neg, computes(kRd, kRd, kAll)},
    {Op::swap, computes(kRd, kRd, 0)},
    {Op::inc, computes(kRd, kRd, kSigns)},
    {Op::dec, computes(kRd, kRd, kSigns)},
    {Op::asr, computes(kRd, kRd, kShifts)},
    {Op::lsr, computes(kRd, kRd, kShifts)},
    {Op::ror, computes(kRd, kRd, kShifts, kC)},
    {Op::bld, computes(kRd, kRd, 0, kT)},
    {Op::bst, computes(kRd, 0, kT)},
    // data memory
    {Op::push, stores(stack)},
    {Op::pop, loads(stack)},
    {Op::ld_x, loads(pointer, kX)},
    {Op::ld_x_inc, loads(pointer, kX, 1)},
    {Op::ld_x_dec, loads(pointer, kX, -1)},
    {Op::ldd_y, loads(displaced, kY)},
    {Op::ld_y_inc, loads(pointer, kY, 1)},
    {Op::ld_y_dec, loads(pointer, kY, -1)},
    {Op::ldd_z, loads(displaced, kZ)},
    {Op::ld_z_inc, loads(pointer, kZ, 1)},
    {Op::ld_z_dec, loads(pointer, kZ, -1)},
    {Op::lds, loads(address)},
    {Op::st_x, stores(pointer, kX)},
    {Op::st_x_inc, stores(pointer, kX, 1)},
    {Op::st_x_dec, stores(pointer, kX, -1)},
    {Op::std_y, stores(displaced, kY)},
    {Op::st_y_inc, stores(pointer, kY, 1)},
    {Op::st_y_dec, stores(pointer, kY, -1)},
    {Op::std_z, stores(displaced, kZ)},
    {Op::st_z_inc, stores(pointer, kZ, 1)},
    {Op::st_z_dec, stores(pointer, kZ, -1)},
    {Op::sts, stores(address)},
    {Op::in, loads(io)},
    {Op::out, stores(io)},
    {Op::sbi, elsewhere(accesses_io_bit(true, straight))},
    {Op::cbi, elsewhere(accesses_io_bit(true, straight))},
    // flash
    {Op::lpm_0, reads_flash(kR0)},
    {Op::lpm, reads_flash(kRd)},
    {Op::lpm_inc, reads_flash(kRd, 1)},
    {Op::elpm_0, elsewhere(reads_flash(kR0))},
    {Op::elpm, elsewhere(reads_flash(kRd))},
    {Op::elpm_inc, elsewhere(reads_flash(kRd, 1))},
    {Op::spm, elsewhere({})},
    // control: reads, flags read
    {Op::rjmp, continues(jump)},
    {Op::jmp, continues(jump)},
    {Op::ijmp, continues(indirect_jump, kPointer)},
    {Op::eijmp, elsewhere(continues(indirect_jump, kPointer))},
    {Op::brbs, continues(branch, 0, kFlagOfB)},
    {Op::brbc, continues(branch, 0, kFlagOfB)},
    {Op::cpse, continues(skip, kRd | kRr)},
    {Op::sbrc, continues(skip, kRd)},
    {Op::sbrs, continues(skip, kRd)},
    {Op::sbic, accesses_io_bit(false, skip)},
    {Op::sbis, accesses_io_bit(false, skip)},
    {Op::rcall, continues(call)},
    {Op::call, continues(call)},
    {Op::icall, continues(indirect_call, kPointer)},
    {Op::eicall, elsewhere(continues(indirect_call, kPointer))},
    {Op::ret, continues(returns)},
    {Op::reti, elsewhere(continues(returns))},
    // the status register and the processor
    {Op::bset, computes(0, 0, kFlagOfB)},
    {Op::bclr, computes(0, 0, kFlagOfB)},
    {Op::nop, {}},
    {Op::wdr, elsewhere({})},
    {Op::break_, elsewhere({})},
    {Op::sleep, elsewhere(continues(stops))},
    {Op::illegal, elsewhere(continues(stops))},
};

/// The table's rows, indexed by Op. Pseudo-operations, which decode() never returns, have `elsewhere` set.
inline constexpr auto kByOp = [] {
  std::array<InstructionRow, 256> rows{};
  for (InstructionRow& row : rows) row.elsewhere = true;
  for (const NamedRow& one : kRows) rows[static_cast<std::size_t>(one.op)] = one.row;
  return rows;
}();

}  // namespace table

constexpr const InstructionRow& row_of(Op op) { return table::kByOp[static_cast<std::size_t>(op)]; }
constexpr Control control_of(Op op) { return row_of(op).control; }
constexpr bool is_call(Op op) {
  return control_of(op) == Control::call || control_of(op) == Control::indirect_call;
}
/// Returns whether the operation stores a register at an address in X, Y or Z.
constexpr bool stores_by_pointer(Op op) {
  const InstructionRow& row = row_of(op);
  return row.stores && (row.location == Location::pointer || row.location == Location::displaced);
}

/// Returns the target of a jump, branch or call at word address `pc`, in a flash of `words`. Relative targets
/// wrap at the end of flash.
constexpr std::uint32_t target_of(const Instruction& i, std::uint32_t pc, std::uint32_t words) {
  if (i.words == 2) return static_cast<std::uint32_t>(i.k);
  return (pc + 1 + static_cast<std::uint32_t>(i.k)) & (std::bit_ceil(words) - 1);
}

}  // namespace robosim::avr
