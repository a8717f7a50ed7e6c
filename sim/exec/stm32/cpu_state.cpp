// Implements the processor's special registers (PM0056 2.1.3), the execution of an instruction by libunicorn,
// and the marks on instructions (Cpu::Mark).
#include <algorithm>
#include <utility>

#include "sim/exec/stm32/cpu.h"
#include "sim/exec/stm32/engine.h"
#include "sim/exec/stm32/unicorn.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kNeverAddress = 0xFFFFFF00;
constexpr std::uint32_t kThumb = 1u << 24, kSaturated = 1u << 27;
constexpr std::uint32_t kFlags = 0xF8000000;
constexpr std::uint32_t kSpSel = 1u << 1;  // CONTROL: selects the process stack
constexpr unsigned kRegisters = 16;        // r0 to r14, xPSR
constexpr int kIds[kRegisters] = {UC_ARM_REG_R0,  UC_ARM_REG_R1, UC_ARM_REG_R2,  UC_ARM_REG_R3,
                                  UC_ARM_REG_R4,  UC_ARM_REG_R5, UC_ARM_REG_R6,  UC_ARM_REG_R7,
                                  UC_ARM_REG_R8,  UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11,
                                  UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR,  UC_ARM_REG_XPSR};
// Special registers by their numbers in MRS and MSR (ARMv7-M ARM, B5.2.2).
enum Special : std::uint32_t {
  kXpsr = 3,
  kMsp = 8,
  kPsp = 9,
  kPrimask = 16,
  kBasepri = 17,
  kBasepriMax = 18,
  kFaultmask = 19,
  kControl = 20
};

}  // namespace

std::uint32_t Cpu::status() const {
  std::uint32_t value = kThumb | state_.flags.pack();
  if (state_.saturated) value |= kSaturated;
  value |= (state_.it & 3) << 25 | (state_.it & 0xFC) << 8;
  if (!state_.handlers.empty()) value |= static_cast<std::uint32_t>(state_.handlers.back().exception);
  return value;
}

void Cpu::set_status(std::uint32_t value) {
  state_.flags.unpack(value);
  state_.saturated = value & kSaturated;
  state_.it = (value >> 25 & 3) | (value >> 8 & 0xFC);
}

void Cpu::select_stack(bool process) {
  if (process != state_.on_process_stack) std::swap(state_.r[kSp], state_.other_sp);
  state_.on_process_stack = process;
  watch_stack();
}

void Cpu::watch_stack() {
  state_.stack_watch = state_.on_process_stack ? 0 : std::max(state_.lowest_sp, state_.stack_limit);
}

void Cpu::check_stack() {
  if (state_.on_process_stack) return;
  const std::uint32_t sp = reg(kSp);
  state_.lowest_sp = std::min(state_.lowest_sp, sp);
  watch_stack();
  if (sp < state_.stack_limit) fail(Fault::Kind::stack, state_.pc);
}

void Cpu::change_masks(std::uint32_t value) {
  const std::uint32_t masks = value >> 4 & 1;
  if (value & 2) state_.primask = masks;
  if (value & 1) state_.faultmask = masks;
  masks_changed();
}

void Cpu::masks_changed() {
  if (nvic_.any_pending()) stop_ = 0;
}

bool Cpu::read_special(std::uint32_t number, std::uint32_t& value) const {
  // The bits of EPSR always read as 0.
  constexpr std::uint32_t kIpsrPart = 1, kWithoutApsr = 4, kExceptionMask = 0x1FF;
  if (number < kMsp) {
    value = status() & ((number & kIpsrPart ? kExceptionMask : 0) | (number & kWithoutApsr ? 0 : kFlags));
    return true;
  }
  switch (number) {
    case kMsp:
      value = state_.on_process_stack ? state_.other_sp : state_.r[kSp];
      return true;
    case kPsp:
      value = state_.on_process_stack ? state_.r[kSp] : state_.other_sp;
      return true;
    case kPrimask:
      value = state_.primask;
      return true;
    case kBasepri:
    case kBasepriMax:
      value = state_.basepri;
      return true;
    case kFaultmask:
      value = state_.faultmask;
      return true;
    case kControl:
      value = state_.on_process_stack ? kSpSel : 0;
      return true;
    default:
      return false;
  }
}

bool Cpu::write_special(std::uint32_t number, std::uint32_t value) {
  constexpr std::uint32_t kPriority = 0xF0;
  if (number <= kXpsr) {
    const std::uint32_t it = state_.it;
    set_status((value & kFlags) | kThumb);
    state_.it = it;
    return true;
  }
  switch (number) {
    case kMsp:
      (state_.on_process_stack ? state_.other_sp : state_.r[kSp]) = value & ~3u;
      return true;
    case kPsp:
      (state_.on_process_stack ? state_.r[kSp] : state_.other_sp) = value & ~3u;
      return true;
    case kFaultmask:
      state_.faultmask = value & 1;
      return true;
    case kControl:
      // All code stays privileged. A handler always uses the main stack.
      if (state_.handlers.empty()) select_stack(value & kSpSel);
      return true;
    case kPrimask:
      state_.primask = value & 1;
      return true;
    case kBasepri:
      state_.basepri = value & kPriority;
      return true;
    case kBasepriMax:
      if (const std::uint32_t limit = value & kPriority;
          limit != 0 && (state_.basepri == 0 || limit < state_.basepri))
        state_.basepri = limit;
      return true;
    default:
      return false;
  }
}

void Cpu::emulate() {
  const Instruction about = decode(half(state_.pc), half(state_.pc + 2));
  if (about.divides && nvic_.traps_division() && about.divisor < kSp && reg(about.divisor) == 0)
    fail(Fault::Kind::division, state_.pc);
  after_ = state_.next;
  idle_.interrupted();
  // Clears ITSTATE for libunicorn. The condition of the instruction is true, and the instruction does not
  // depend on the rest of its IT block.
  const std::uint32_t it = std::exchange(state_.it, 0);
  std::uint32_t psr = status();
  for (unsigned i = 0; i < kRegisters; ++i) uc_reg_write(uc_, kIds[i], i < 15 ? &state_.r[i] : &psr);
  // Discards libunicorn's translation of code in RAM, because the firmware may have overwritten this code.
  if (state_.pc >= kRam) uc_ctl_remove_cache(uc_, kRam, kRam + kRamBytes);
  first_ = true;
  block_bytes_ = 0;
  if (about.predicates > 0) {
    block_bytes_ = about.bytes;
    for (int i = 0; i < about.predicates; ++i)
      block_bytes_ += decode(half(state_.pc + block_bytes_), half(state_.pc + block_bytes_ + 2)).bytes;
  }
  engine_.runs();
  const uc_err error = uc_emu_start(uc_, state_.pc | 1, kNeverAddress, 0, 0);
  for (unsigned i = 0; i < kRegisters; ++i) uc_reg_read(uc_, kIds[i], i < 15 ? &state_.r[i] : &psr);
  set_status(psr);
  state_.it = it;
  if (about.grows_stack) check_stack();
  if (about.masks) masks_changed();
  if (state_.returning || state_.fault) ends_ = true;
  if (error != UC_ERR_OK && !ends_) fail(Fault::Kind::bad_opcode, state_.pc, opcode(state_.pc));
}

Cpu::Mark* Cpu::mark_at(std::uint32_t pc) {
  std::uint16_t& known = known_marks_[pc / 2 % known_marks_.size()];
  if (known < marks_.size() && marks_[known].pc == pc) return &marks_[known];
  const auto at = std::ranges::lower_bound(marks_, pc, {}, &Mark::pc);
  if (at == marks_.end() || at->pc != pc) return nullptr;
  known = static_cast<std::uint16_t>(at - marks_.begin());
  return &*at;
}

void Cpu::mark(std::uint32_t pc, bool Mark::*flag, bool set) {
  if (pc < kFlash || pc >= kFlash + kFlashBytes) return;
  auto at = std::ranges::lower_bound(marks_, pc, {}, &Mark::pc);
  if (at == marks_.end() || at->pc != pc) {
    at = marks_.emplace(at);
    at->pc = pc;
  }
  (*at).*flag = set;
  if (!at->is_set()) marks_.erase(at);
  code_[(pc - kFlash) / 2].kind = Step::Kind::fetch;
}

void Cpu::count(LineCounts& lines) {
  lines_ = &lines;
  for (const LineCounts::Begin& begin : lines.begins()) mark(begin.address, &Mark::counted);
}

}  // namespace robosim::exec::stm32
