#include "sim/exec/avr/data_flow.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Cpu;
using robosim::avr::Instruction;
using robosim::avr::Op;

bool may_skip(Op op) {
  return op == Op::cpse || op == Op::sbrc || op == Op::sbrs || op == Op::sbic || op == Op::sbis;
}

}  // namespace

bool is_straight(Op op) {
  switch (op) {
    case Op::rjmp:
    case Op::jmp:
    case Op::rcall:
    case Op::call:
    case Op::ijmp:
    case Op::icall:
    case Op::eijmp:
    case Op::eicall:
    case Op::ret:
    case Op::reti:
    case Op::brbs:
    case Op::brbc:
    case Op::cpse:
    case Op::sbrc:
    case Op::sbrs:
    case Op::sbic:
    case Op::sbis:
    case Op::sleep:
    case Op::illegal:
      return false;
    default:
      return true;
  }
}

bool is_store_by_pointer(Op op) { return op >= Op::st_x && op <= Op::st_z_dec; }

void add_next(const Cpu& cpu, std::uint32_t pc, bool into_calls, std::vector<std::uint32_t>& next) {
  const Instruction& i = cpu.instruction(pc);
  const std::uint32_t behind = pc + i.words;
  if (i.op == Op::jmp || (i.op == Op::call && into_calls)) next.push_back(static_cast<std::uint32_t>(i.k));
  if (i.op == Op::rjmp || i.op == Op::brbs || i.op == Op::brbc || (i.op == Op::rcall && into_calls))
    next.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(pc) + 1 + i.k));
  if (may_skip(i.op)) next.push_back(behind + cpu.instruction(behind).words);
  if (i.op != Op::jmp && i.op != Op::rjmp && i.op != Op::ijmp && i.op != Op::eijmp && i.op != Op::ret &&
      i.op != Op::reti)
    next.push_back(behind);
}

std::vector<bool> without_interrupts(const Cpu& cpu, std::uint32_t code_end) {
  std::vector<bool> off(code_end / 2 + 2), entered(off.size());
  const auto enter = [&](std::int64_t pc) {
    if (pc >= 0 && pc < static_cast<std::int64_t>(entered.size()))
      entered[static_cast<std::size_t>(pc)] = true;
  };
  for (std::uint32_t pc = 0; 2 * pc < code_end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    if (i.op == Op::jmp || i.op == Op::call) enter(i.k);
    if (i.op == Op::rjmp || i.op == Op::rcall || i.op == Op::brbs || i.op == Op::brbc)
      enter(std::int64_t{pc} + 1 + i.k);
  }
  bool is_off = false, may_be_skipped = false;
  for (std::uint32_t pc = 0; 2 * pc < code_end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    is_off = is_off && !entered[pc];
    off[pc] = is_off;
    if (i.op == Op::bclr && i.b == Cpu::kI)
      is_off = !may_be_skipped;
    else if ((i.op == Op::bset && i.b == Cpu::kI) || i.op == Op::out || !is_straight(i.op))
      is_off = false;
    may_be_skipped = may_skip(i.op);
  }
  return off;
}

std::vector<bool> of_handlers(const Cpu& cpu, std::uint32_t code_end) {
  std::vector<bool> its(code_end / 2 + 2);
  std::vector<std::uint32_t> next;
  for (int vector = 1; vector < cpu.chip().vectors; ++vector) next.push_back(cpu.entry_of(vector));
  while (!next.empty()) {
    const std::uint32_t pc = next.back();
    next.pop_back();
    if (pc == 0 || 2 * pc >= code_end || its[pc]) continue;
    its[pc] = true;
    add_next(cpu, pc, false, next);
  }
  return its;
}

void ValueFlow::follow(const Instruction& i) {
  switch (i.op) {
    case Op::add:
    case Op::adc:
    case Op::sub:
    case Op::sbc:
    case Op::and_:
    case Op::or_:
    case Op::eor:
      if (i.a == i.b && (i.op == Op::eor || i.op == Op::sub)) return drop(i.a);
      if (has(i.a) || has(i.b)) change(i.a);
      return;
    case Op::mov:
      return copy(i.a, i.b);
    case Op::movw:
      copy(i.a, i.b);
      return copy(i.a + 1, i.b + 1);
    case Op::subi:
    case Op::sbci:
    case Op::andi:
    case Op::ori:
    case Op::adiw:
    case Op::sbiw:
    case Op::com:
    case Op::neg:
    case Op::swap:
    case Op::inc:
    case Op::dec:
    case Op::asr:
    case Op::lsr:
    case Op::ror:
    case Op::bld:
      if (has(i.a)) change(i.a);
      return;
    case Op::mul:
    case Op::muls:
    case Op::mulsu: {
      const bool made = has(i.a) || has(i.b);
      for (const int product : {0, 1}) made ? change(product) : drop(product);
      return;
    }
    case Op::cp:
    case Op::cpc:
    case Op::cpi:
    case Op::bst:
    case Op::push:
    case Op::sts:
    case Op::out:
      return;
    default:
      drop(i.a);
  }
}

}  // namespace robosim::exec::avr
