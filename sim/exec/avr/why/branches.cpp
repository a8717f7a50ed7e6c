#include "sim/exec/avr/why/branches.h"

#include <set>

#include "sim/exec/avr/why/instruction_log.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Instruction;

}  // namespace

Branches::Branches(const robosim::avr::Cpu& cpu) : cpu_(cpu), writes_(cpu.flash().size() / 2) {
  for (std::uint32_t pc = 0; pc < writes_.size(); ++pc)
    writes_[pc] = effects_of_logged(cpu.instruction(pc), cpu).writes;
}

bool Branches::is_branch(std::uint32_t pc) const {
  const Control control = control_of(cpu_.instruction(pc).op);
  return control == Control::skip || control == Control::branch;
}

std::optional<std::uint32_t> Branches::called_at(std::uint32_t pc) const {
  const Instruction& i = cpu_.instruction(pc);
  if (control_of(i.op) != Control::call) return std::nullopt;
  const std::uint32_t called = target_of(i, pc, words());
  return called < words() ? std::optional(called) : std::nullopt;
}

std::vector<std::uint32_t> Branches::ways_on(std::uint32_t pc) const {
  const Instruction& i = cpu_.instruction(pc);
  const Control control = control_of(i.op);
  const std::uint32_t behind = pc + i.words;
  std::vector<std::uint32_t> ways;
  if (control != Control::jump && control != Control::indirect_jump && control != Control::returns)
    ways.push_back(behind);
  if (control == Control::jump || control == Control::branch) ways.push_back(target_of(i, pc, words()));
  if (control == Control::skip && behind < words()) ways.push_back(behind + cpu_.instruction(behind).words);
  std::erase_if(ways, [&](std::uint32_t way) { return way >= words(); });
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
