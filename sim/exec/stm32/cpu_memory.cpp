// Implements the loads, stores and rare data operations that the interpreter's loop does not implement itself
// (ARMv7-M ARM, A7.7). A function that returns false has changed nothing.
#include <bit>
#include <cstring>

#include "sim/exec/stm32/cpu.h"
#include "sim/exec/stm32/thumb_values.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

bool Cpu::has_registers(Address address) {
  return address - kPeripherals < kPeripheralBytes || address - kBitBand < kBitBandBytes ||
         address - kPrivate < kPrivateBytes;
}

const std::uint8_t* Cpu::memory(Address address, unsigned bytes) const {
  if (const std::uint8_t* in_ram = ram(address, bytes)) return in_ram;
  if (const std::uint8_t* facts = chip_facts(address, bytes)) return facts;
  const Address offset = address < kFlash ? address : address - kFlash;
  return offset <= kFlashBytes - bytes ? flash_ + offset : nullptr;
}

std::optional<std::uint32_t> Cpu::load_elsewhere(Address address, unsigned bytes) {
  std::uint32_t value = 0;
  if (!has_registers(address)) {
    const std::uint8_t* const from = memory(address, bytes);
    if (!from) return std::nullopt;
    std::memcpy(&value, from, bytes);
    return value;
  }
  if (address % bytes != 0) return std::nullopt;
  const Cycle until = idle_.is_recording() ? bus_.same_until(address) : 0;
  value = bus_.load(address, bytes);
  accessed();
  if (idle_.is_recording()) idle_.looks(until);
  return value;
}

bool Cpu::store_elsewhere(Address address, unsigned bytes, std::uint32_t value) {
  if (std::uint8_t* const to = ram(address, bytes)) {
    idle_.stores(address, bytes);
    std::memcpy(to, &value, bytes);
    return true;
  }
  if (address % bytes != 0 || (!has_registers(address) && !bus_.programs(address, bytes))) return false;
  if (bytes < 4) value &= (1u << (8 * bytes)) - 1;
  idle_.interrupted();
  bus_.store(address, value, bytes);
  if (const auto page = bus_.take_changed_page()) forget(*page);
  accessed();
  return true;
}

void Cpu::accessed() {
  if (state_.handlers.empty()) {
    state_.last_io = clock_.now;
    state_.last_io_pc = state_.pc;
  }
  if (bus_.unmodelled()) return fail(Fault::Kind::unmodelled, state_.pc, bus_.unmodelled()->address);
  if (nvic_.any_pending()) stop_ = 0;
  stop_ = std::min(stop_, bus_.next_event());
  if (const SimTime input = bus_.link().board.next_input(); input != kNever)
    stop_ = std::min(stop_, clock_.cycle_at(input));
}

bool Cpu::load_target(Address address, std::uint32_t& target) const {
  const std::uint8_t* const from = memory(address, 4);
  if (from) std::memcpy(&target, from, 4);
  return from && target & 1;
}

bool Cpu::load_two(const Step& step) {
  const std::uint32_t moved = state_.r[step.n] + step.value;
  const std::uint32_t address = step.shift & 1 ? moved : state_.r[step.n];
  const std::uint8_t* const from = address & 3 ? nullptr : memory(address, 8);
  if (!from) return false;
  std::memcpy(&state_.r[step.d], from, 4);
  std::memcpy(&state_.r[step.m], from + 4, 4);
  if (step.shift & 2) state_.r[step.n] = moved;
  return true;
}

bool Cpu::store_two(const Step& step) {
  const std::uint32_t moved = state_.r[step.n] + step.value;
  const std::uint32_t address = step.shift & 1 ? moved : state_.r[step.n];
  std::uint8_t* const to = address & 3 ? nullptr : ram(address, 8);
  if (!to) return false;
  idle_.stores(address, 8);
  std::memcpy(to, &state_.r[step.d], 4);
  std::memcpy(to + 4, &state_.r[step.m], 4);
  if (step.shift & 2) state_.r[step.n] = moved;
  return true;
}

bool Cpu::load_many(const Step& step, std::uint32_t registers) {
  const std::uint32_t bytes = 4 * (step.cycles - 1u);
  const bool down = step.shift & 1;
  const std::uint32_t base = state_.r[step.n], low = down ? base - bytes : base;
  const std::uint8_t* from = low & 3 ? nullptr : memory(low, bytes);
  if (!from) return false;
  for (; registers != 0; registers &= registers - 1, from += 4)
    std::memcpy(&state_.r[static_cast<unsigned>(std::countr_zero(registers))], from, 4);
  if (step.shift & 2) state_.r[step.n] = down ? low : base + bytes;
  return true;
}

bool Cpu::store_many(const Step& step) {
  const std::uint32_t bytes = 4 * (step.cycles - 1u);
  const bool down = step.shift & 1;
  const std::uint32_t base = state_.r[step.n], low = down ? base - bytes : base;
  std::uint8_t* to = low & 3 ? nullptr : ram(low, bytes);
  if (!to) return false;
  idle_.stores(low, bytes);
  for (std::uint32_t registers = step.value; registers != 0; registers &= registers - 1, to += 4)
    std::memcpy(to, &state_.r[static_cast<unsigned>(std::countr_zero(registers))], 4);
  if (step.shift & 2) state_.r[step.n] = down ? low : base + bytes;
  return true;
}

void Cpu::multiply_long(const Step& step) {
  const auto op = static_cast<Op>(step.value);
  const std::uint32_t n = state_.r[step.n], m = state_.r[step.m];
  const bool is_signed = op == Op::smull || op == Op::smlal;
  std::uint64_t product = is_signed ? static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(n)} *
                                                                 static_cast<std::int32_t>(m))
                                    : std::uint64_t{n} * m;
  if (op >= Op::umlal) product += std::uint64_t{state_.r[step.shift]} << 32 | state_.r[step.d];
  state_.r[step.d] = static_cast<std::uint32_t>(product);
  state_.r[step.shift] = static_cast<std::uint32_t>(product >> 32);
}

void Cpu::compute(Op op, const Step& step, std::uint32_t b, std::uint32_t carry, bool sets, Flags& flags) {
  const std::uint32_t n = state_.r[step.n];
  Flags made = flags;
  const auto logical = [&](std::uint32_t result) {
    made.carry = carry;
    return made.logic(result);
  };
  std::uint32_t& d = state_.r[step.d];
  switch (op) {
    case Op::mov:
      d = logical(b);
      break;
    case Op::mvn:
      d = logical(~b);
      break;
    case Op::and_:
      d = logical(n & b);
      break;
    case Op::orr:
      d = logical(n | b);
      break;
    case Op::orn:
      d = logical(n | ~b);
      break;
    case Op::eor:
      d = logical(n ^ b);
      break;
    case Op::bic:
      d = logical(n & ~b);
      break;
    case Op::add:
      d = made.sum(n, b);
      break;
    case Op::adc:
      d = made.sum_with_carry(n, b);
      break;
    case Op::sub:
      d = made.difference(n, b);
      break;
    case Op::sbc:
      d = made.sum_with_carry(n, ~b);
      break;
    case Op::rsb:
      d = made.difference(b, n);
      break;
    case Op::tst:
      logical(n & b);
      break;
    case Op::teq:
      logical(n ^ b);
      break;
    case Op::cmp:
      made.difference(n, b);
      break;
    default:
      made.sum(n, b);
  }
  if (sets) flags = made;
}

}  // namespace robosim::exec::stm32
