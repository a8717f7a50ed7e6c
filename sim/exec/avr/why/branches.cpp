#include "sim/exec/avr/why/branches.h"

#include <bit>
#include <set>

#include "sim/exec/avr/why/instruction_log.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Instruction;
using robosim::avr::Op;

bool skips(Op op) {
  return op == Op::cpse || op == Op::sbrc || op == Op::sbrs || op == Op::sbic || op == Op::sbis;
}

bool branches(Op op) { return op == Op::brbs || op == Op::brbc; }

}  // namespace

Branches::Branches(const robosim::avr::Cpu& cpu) : cpu_(cpu), writes_(cpu.flash().size() / 2) {
  for (std::uint32_t pc = 0; pc < writes_.size(); ++pc)
    writes_[pc] = effects_of_logged(cpu.instruction(pc), cpu).writes;
}

bool Branches::is_branch(std::uint32_t pc) const {
  const Op op = cpu_.instruction(pc).op;
  return skips(op) || branches(op);
}

std::uint32_t Branches::led_to(std::uint32_t pc, std::int32_t by) const {
  const auto words = static_cast<std::uint32_t>(cpu_.flash().size() / 2);
  return (pc + 1 + static_cast<std::uint32_t>(by)) & (std::bit_ceil(words) - 1);
}

std::optional<std::uint32_t> Branches::called_at(std::uint32_t pc) const {
  const Instruction& i = cpu_.instruction(pc);
  if (i.op != Op::call && i.op != Op::rcall) return std::nullopt;
  const std::uint32_t called = i.op == Op::call ? static_cast<std::uint32_t>(i.k) : led_to(pc, i.k);
  return called < cpu_.flash().size() / 2 ? std::optional(called) : std::nullopt;
}

std::vector<std::uint32_t> Branches::ways_on(std::uint32_t pc) const {
  const auto words = static_cast<std::uint32_t>(cpu_.flash().size() / 2);
  const Instruction& i = cpu_.instruction(pc);
  const std::uint32_t behind = pc + i.words;
  const auto relative = [&] { return led_to(pc, i.k); };
  std::vector<std::uint32_t> ways;
  if (branches(i.op)) {
    ways = {behind, relative()};
  } else if (skips(i.op)) {
    ways = {behind};
    if (behind < words) ways.push_back(behind + cpu_.instruction(behind).words);
  } else if (i.op == Op::rjmp) {
    ways = {relative()};
  } else if (i.op == Op::jmp) {
    ways = {static_cast<std::uint32_t>(i.k)};
  } else if (i.op != Op::ret && i.op != Op::reti && i.op != Op::ijmp && i.op != Op::eijmp) {
    ways = {behind};
  }
  std::erase_if(ways, [&](std::uint32_t way) { return way >= words; });
  return ways;
}

bool Branches::avoids(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const {
  std::set<std::uint32_t> seen{from};
  std::vector<std::uint32_t> open{from};
  while (!open.empty()) {
    const std::uint32_t here = open.back();
    open.pop_back();
    if (here == pc) continue;
    if (here == branch) return true;
    const std::vector<std::uint32_t> ways = ways_on(here);
    if (ways.empty()) return true;
    for (const std::uint32_t way : ways)
      if (seen.insert(way).second) open.push_back(way);
  }
  return false;
}

bool Branches::decides(std::uint32_t branch, std::uint32_t next, std::uint32_t pc) {
  const auto [known, fresh] = known_.try_emplace({branch, next, pc}, false);
  if (!fresh) return known->second;
  for (const std::uint32_t way : ways_on(branch))
    if (way != next && avoids(way, branch, pc)) known->second = true;
  return known->second;
}

}  // namespace robosim::exec::avr
