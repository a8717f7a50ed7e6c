// Loads and stores that do more than one thing (ARMv7-M ARM, A7.7), and where they lead. What returns false
// has changed nothing.
#include <bit>

#include "sim/exec/stm32/cpu_memory.h"
#include "sim/exec/stm32/thumb_values.h"

namespace robosim::exec::stm32 {

bool Cpu::load_as(Op op, Address address, std::uint32_t& value) {
  switch (op) {
    case Op::ldr:
      return load<4>(address, value);
    case Op::ldrb:
      return load<1>(address, value);
    case Op::ldrh:
      return load<2>(address, value);
    case Op::ldrsb:
      if (!load<1>(address, value)) return false;
      value = sign_extended(value, 8);
      return true;
    default:
      if (!load<2>(address, value)) return false;
      value = sign_extended(value, 16);
      return true;
  }
}

bool Cpu::store_as(Op op, Address address, std::uint32_t value) {
  return op == Op::str    ? store<4>(address, value)
         : op == Op::strh ? store<2>(address, value)
                          : store<1>(address, value);
}

bool Cpu::branch_to(std::uint32_t target) {
  if (!(target & 1)) return false;
  after_ = target & ~1u;
  if (target >= kExceptionReturn) returning_ = ends_ = true;
  return true;
}

bool Cpu::transfer_back(const Thumb& t) {
  const auto op = static_cast<Op>(static_cast<unsigned>(t.op) - static_cast<unsigned>(Op::ldr_back) +
                                  static_cast<unsigned>(Op::ldr));
  const std::uint32_t moved = r_[t.n] + t.value;
  const std::uint32_t address = t.shift ? moved : r_[t.n];
  if (op >= Op::str) {
    if (!store_as(op, address, r_[t.d])) return false;
  } else {
    std::uint32_t value = 0;
    if (!load_as(op, address, value)) return false;
    if (t.d == kPc) {
      if (!branch_to(value)) return false;
    } else {
      r_[t.d] = value;
    }
  }
  r_[t.n] = moved;
  return true;
}

bool Cpu::transfer_two(const Thumb& t) {
  const std::uint32_t moved = r_[t.n] + t.value;
  const std::uint32_t address = t.shift & 1 ? moved : r_[t.n];
  if (address & 3) return false;
  if (t.op == Op::ldrd) {
    const std::uint8_t* const from = memory(address, 8);
    if (!from) return false;
    std::memcpy(&r_[t.d], from, 4);
    std::memcpy(&r_[t.m], from + 4, 4);
  } else {
    std::uint8_t* const to = ram(address, 8);
    if (!to) return false;
    std::memcpy(to, &r_[t.d], 4);
    std::memcpy(to + 4, &r_[t.m], 4);
  }
  if (t.shift & 2) r_[t.n] = moved;
  return true;
}

bool Cpu::transfer_many(const Thumb& t) {
  const auto bytes = 4 * static_cast<std::uint32_t>(std::popcount(t.value));
  const bool down = t.shift & 1;
  const std::uint32_t base = r_[t.n], low = down ? base - bytes : base;
  if (low & 3) return false;
  std::uint32_t registers = t.value;
  if (t.op == Op::stm) {
    std::uint8_t* to = ram(low, bytes);
    if (!to) return false;
    for (; registers != 0; registers &= registers - 1, to += 4)
      std::memcpy(to, &r_[static_cast<unsigned>(std::countr_zero(registers))], 4);
  } else {
    const std::uint8_t* from = memory(low, bytes);
    if (!from) return false;
    if (registers & 1u << kPc) {
      std::uint32_t target;
      std::memcpy(&target, from + bytes - 4, 4);
      if (!branch_to(target)) return false;
      registers &= ~(1u << kPc);
    }
    for (; registers != 0; registers &= registers - 1, from += 4)
      std::memcpy(&r_[static_cast<unsigned>(std::countr_zero(registers))], from, 4);
  }
  if (t.shift & 2) r_[t.n] = down ? low : base + bytes;
  return true;
}

}  // namespace robosim::exec::stm32
