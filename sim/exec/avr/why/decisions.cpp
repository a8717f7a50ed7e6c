#include <algorithm>

#include "sim/exec/avr/why/causes.h"

// What has decided that an instruction ran, or that a value stayed as it was.

namespace robosim::exec::avr {
namespace {

using robosim::avr::each;
using robosim::avr::Instruction;
using robosim::avr::Op;
using Entry = InstructionLog::Entry;

constexpr int kOfBranch = 2;           // how far a branch is from what it decides
constexpr std::size_t kTogether = 40;  // instructions behind a branch; its ways mostly meet within them

}  // namespace

void Causes::want_branch(Index index, Want want) {
  const auto& entries = log_->entries();
  const auto at = [&](Index i) -> const Entry& { return entries[static_cast<std::size_t>(i)]; };
  for (;; index = frames_[static_cast<std::size_t>(index)]) {
    if (index == kNone || at(index).interrupts) return;
    const bool is_described = sketch_.at(at(index).pc).is_described;
    const bool starts_up = !is_described && frames_[static_cast<std::size_t>(index)] == kNone;
    if (!starts_up) add_pending(index, want);
    if (is_described) return;
  }
}

void Causes::add_pending(Index index, Want want) {
  const std::uint32_t pc = log_->entries()[static_cast<std::size_t>(index)].pc;
  if (want.far + far_of_branch(pc) > kFarthest) return;
  std::vector<Pending>& waiting = pending_[frames_[static_cast<std::size_t>(index)]];
  for (Pending& one : waiting)
    if (one.pc == pc) {
      if (want.far < one.want.far) one.want = want;
      return;
    }
  waiting.push_back({pc, want});
}

/// In routines of the compiler's, which have no lines, branches belong to the line that has called them.
int Causes::far_of_branch(std::uint32_t pc) const { return sketch_.at(pc).is_described ? kOfBranch : 0; }

void Causes::visit_branch(Index index) {
  const auto waiting = pending_.find(frames_[static_cast<std::size_t>(index)]);
  if (waiting == pending_.end()) return;
  const auto& entries = log_->entries();
  const Entry& e = entries[static_cast<std::size_t>(index)];
  if (!branches_->is_branch(e.pc) || sketch_.at(e.pc).is_pause ||
      static_cast<std::size_t>(index) + 1 >= entries.size())
    return;
  const Entry& next = entries[static_cast<std::size_t>(index) + 1];
  if (next.interrupts) return;
  std::optional<Want> best;
  std::erase_if(waiting->second, [&](const Pending& one) {
    if (one.pc != kLast && !branches_->decides(e.pc, next.pc, one.pc)) return false;
    if (!best || one.want.far < best->far) best = one.want;
    return true;
  });
  if (waiting->second.empty()) pending_.erase(waiting);
  if (best) take(index, {best->far + far_of_branch(e.pc), best->line}, CauseStep::Kind::decides);
}

/// A branch whose other way would have written what is wanted, and which so left it as it was.
void Causes::visit_left_out(Index index) {
  const auto& entries = log_->entries();
  const auto at = static_cast<std::size_t>(index);
  const std::uint32_t branch = entries[at].pc;
  if (!branches_->is_branch(branch) || sketch_.at(branch).is_pause || at + 1 >= entries.size() ||
      entries[at + 1].interrupts)
    return;
  const auto& cpu = machine_->chip().chip().cpu();
  const auto has_run = [&](std::uint32_t pc) {  // both ways have come together there
    const auto from = entries.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    return std::any_of(
        from, entries.begin() + static_cast<std::ptrdiff_t>(std::min(at + kTogether, entries.size())),
        [&](const Entry& e) { return e.pc == pc; });
  };
  std::optional<Want> best;
  const auto kept = [&](const std::optional<Want>& wanted) {
    if (wanted && (!best || wanted->far < best->far)) best = wanted;
  };
  for (const std::uint32_t pc : branches_->left_out(branch, entries[at + 1].pc)) {
    if (has_run(pc)) {
      if (best) take(index, {best->far + far_of_branch(branch), best->line}, CauseStep::Kind::decides);
      return;
    }
    const Instruction& i = cpu.instruction(pc);
    each(effects_of_logged(i, cpu).writes, [&](unsigned reg) { kept(registers_[reg]); });
    if (i.op != Op::sts) continue;
    if (const auto byte = bytes_.find(static_cast<std::uint16_t>(i.k)); byte != bytes_.end())
      kept(byte->second);
  }
}

}  // namespace robosim::exec::avr
