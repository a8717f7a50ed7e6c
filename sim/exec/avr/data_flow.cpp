#include "sim/exec/avr/data_flow.h"

#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Cpu;
using robosim::avr::Instruction;
using robosim::avr::Op;
using robosim::avr::target_of;

std::uint32_t words_of(const Cpu& cpu) { return static_cast<std::uint32_t>(cpu.flash().size() / 2); }

}  // namespace

void add_next(const Cpu& cpu, std::uint32_t pc, bool into_calls, std::vector<std::uint32_t>& next) {
  const Instruction& i = cpu.instruction(pc);
  const Control control = control_of(i.op);
  const std::uint32_t behind = pc + i.words;
  if (control == Control::jump || control == Control::branch || (control == Control::call && into_calls))
    next.push_back(target_of(i, pc, words_of(cpu)));
  if (control == Control::skip) next.push_back(behind + cpu.instruction(behind).words);
  if (control != Control::jump && control != Control::indirect_jump && control != Control::returns)
    next.push_back(behind);
}

std::vector<bool> without_interrupts(const Cpu& cpu, std::uint32_t code_end) {
  std::vector<bool> off(code_end / 2 + 2), entered(off.size());
  for (std::uint32_t pc = 0; 2 * pc < code_end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    const Control control = control_of(i.op);
    if (control != Control::jump && control != Control::branch && control != Control::call) continue;
    if (const std::uint32_t target = target_of(i, pc, words_of(cpu)); target < entered.size())
      entered[target] = true;
  }
  bool is_off = false, may_be_skipped = false;
  for (std::uint32_t pc = 0; 2 * pc < code_end; pc += cpu.instruction(pc).words) {
    const Instruction& i = cpu.instruction(pc);
    is_off = is_off && !entered[pc];
    off[pc] = is_off;
    if (i.op == Op::bclr && i.b == Cpu::kI)
      is_off = !may_be_skipped;
    else if ((i.op == Op::bset && i.b == Cpu::kI) || i.op == Op::out || control_of(i.op) != Control::straight)
      is_off = false;
    may_be_skipped = control_of(i.op) == Control::skip;
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
  if (robosim::avr::row_of(i.op).stores) return;
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
      return;
    default:
      drop(i.a);
  }
}

}  // namespace robosim::exec::avr
