#include <algorithm>

#include "sim/exec/avr/why/backward_slice.h"

// Finds the branch that decided that an instruction ran, or that a value was not changed.

namespace robosim::exec::avr {
namespace {

using robosim::avr::each;
using robosim::avr::Instruction;
using robosim::avr::Op;
using Entry = InstructionLog::Entry;

constexpr int kOfBranch = 2;             // distance, in lines, of a branch from an instruction it controls
constexpr std::size_t kTogether = 4000;  // log entries searched for the place where a branch's paths meet
constexpr std::int32_t kPointerBefore = 100;

bool points_by(Op op, unsigned pair) {
  return pair == 26   ? op == Op::ld_x || op == Op::st_x
         : pair == 28 ? op == Op::ldd_y || op == Op::std_y
                      : op == Op::ldd_z || op == Op::std_z;
}

}  // namespace

void BackwardSlice::want_branch(Index index, Want want) {
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

void BackwardSlice::add_pending(Index index, Want want) {
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

/// Returns the distance, in lines, of a branch from its effect. Routines of the compiler's library have no
/// source lines, so their branches belong to the line that called the routine.
int BackwardSlice::far_of_branch(std::uint32_t pc) const {
  return sketch_.at(pc).is_described ? kOfBranch : 0;
}

void BackwardSlice::visit_branch(Index index) {
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

/// Adds a branch to the slice if it has left a wanted value unchanged. The path that was not taken would have
/// written the value before the two paths meet.
void BackwardSlice::visit_skipped_writes(Index index) {
  const auto& entries = log_->entries();
  const auto at = static_cast<std::size_t>(index);
  const std::uint32_t branch = entries[at].pc;
  if (!branches_->is_branch(branch) || sketch_.at(branch).is_pause || at + 1 >= entries.size() ||
      entries[at + 1].interrupts)
    return;
  if (!sketch_.at(branch).is_described && frames_[at] == kNone) return;  // the start-up code
  const Branches::SkippedWrites& skipped_writes = branches_->skipped_writes(branch, entries[at + 1].pc);
  std::optional<Want> best;
  std::optional<Index> meeting;
  const auto kept = [&](const Want& wanted) {
    if (best && best->far <= wanted.far) return;
    if (!meeting) meeting = meeting_behind(index, skipped_writes.meets);
    if (wanted.by >= *meeting) best = wanted;
  };
  each(skipped_writes.registers, [&](unsigned reg) {
    if (registers_[reg]) kept(*registers_[reg]);
  });
  for (const auto& [address, wanted] : bytes_)
    if (std::binary_search(skipped_writes.bytes.begin(), skipped_writes.bytes.end(), address)) kept(wanted);
  for (const auto& [pair, offsets] : skipped_writes.bytes_by_pointer)
    if (const auto pointer = bytes_.empty() ? std::nullopt : pointer_at(index, pair))
      for (const std::uint8_t offset : offsets)
        if (const auto byte = bytes_.find(static_cast<std::uint16_t>(*pointer + offset));
            byte != bytes_.end())
          kept(byte->second);
  if (best) take(index, {best->far + far_of_branch(branch), best->line}, CauseStep::Kind::decides);
}

/// Returns the first entry after the branch that the program would also have reached on the other path.
/// Returns kLater if there is no such entry soon after the branch.
BackwardSlice::Index BackwardSlice::meeting_behind(Index branch, std::uint32_t meets) const {
  const auto& entries = log_->entries();
  const Index frame = frames_[static_cast<std::size_t>(branch)];
  const auto end = static_cast<Index>(std::min(static_cast<std::size_t>(branch) + kTogether, entries.size()));
  const auto has_left = [&](const Entry& e) {
    if (frame == kNone) return false;
    const Entry& call = entries[static_cast<std::size_t>(frame)];
    return e.sp >= call.sp + (call.interrupts ? firmware_.chip->return_address_bytes : 0);
  };
  for (Index i = branch + 1; i < end; ++i) {
    const Entry& e = entries[static_cast<std::size_t>(i)];
    if (has_left(e) || (frames_[static_cast<std::size_t>(i)] == frame && e.pc == meets)) return i;
  }
  return kLater;
}

/// Returns the value of a register pair at an entry, or nullopt if the value is unknown. The value is known
/// if the same function has recently accessed memory through the pair or its copy.
std::optional<std::uint16_t> BackwardSlice::pointer_at(Index index, unsigned pair) const {
  const auto& entries = log_->entries();
  const auto& cpu = machine_->chip().chip().cpu();
  const Index frame = frames_[static_cast<std::size_t>(index)];
  std::array<std::optional<std::uint16_t>, 3> used;  // values of X, Y and Z at entry i
  for (Index i = index; i >= 0 && index - i < kPointerBefore; --i) {
    const Entry& e = entries[static_cast<std::size_t>(i)];
    if (frames_[static_cast<std::size_t>(i)] != frame || e.interrupts) continue;
    const Instruction& instruction = cpu.instruction(e.pc);
    const std::uint32_t writes = branches_->writes_of(e.pc);
    for (unsigned pointer = 26; pointer <= 30; pointer += 2) {
      auto& there = used[(pointer - 26) / 2];
      if (instruction.op == Op::movw && instruction.a == pointer && instruction.b == pair && there)
        return there;
      if ((writes & (3u << pointer)) != 0) there.reset();
      if ((writes & (3u << pointer)) == 0 && points_by(instruction.op, pointer))
        there = static_cast<std::uint16_t>(e.address - (pointer == 26 ? 0 : instruction.b));
      if (pointer == pair && there) return there;
    }
    if ((writes & (3u << pair)) != 0) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace robosim::exec::avr
