// Exceptions of the Cortex-M3: how the processor enters and leaves their handlers (PM0056 2.3.7).
#include <cstring>

#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kAligned = 1u << 9;
constexpr Cycle kEntryCycles = 12, kExitCycles = 10, kTailChainCycles = 6;  // DDI 0337E, 5.5, 5.6

}  // namespace

void Cpu::take_exception() {
  if (!nvic_.any_pending() || fault_) return;
  if (const Exception exception = nvic_.next(primask_ | faultmask_, basepri_)) enter(exception);
}

// r0 to r3, r12, lr, pc, xpsr, on a stack aligned to 8.
void Cpu::enter(Exception exception) {
  const std::uint32_t sp = reg(kSp);
  std::uint32_t psr = status() & ~kAligned;
  if (sp & 4) psr |= kAligned;
  const std::uint32_t frame_at = (sp - 32) & ~7u;
  std::uint8_t* const frame = ram(frame_at, 32);
  if (!frame) return fail(Fault::Kind::stack, next_);
  const std::uint32_t words[8] = {reg(0), reg(1), reg(2), reg(3), reg(12), reg(kLr), next_, psr};
  std::memcpy(frame, words, sizeof words);
  std::uint32_t target = 0;
  const Address vector = nvic_.vectors() + 4u * static_cast<Address>(exception);
  const Address at = vector < kFlash ? vector : vector - kFlash;
  if (at + 4 <= kFlashBytes) std::memcpy(&target, flash_ + at, 4);
  if (const std::uint8_t* in_ram = ram(vector, 4)) std::memcpy(&target, in_ram, 4);
  if ((target & 1) == 0) return fail(Fault::Kind::unhandled, next_, static_cast<std::uint32_t>(exception));
  if (handlers_.empty()) {
    handler_began_ = clock_.now;
    interrupted_pc_ = next_;
  }
  set_reg(kSp, frame_at);
  set_reg(kLr, !handlers_.empty() ? 0xFFFFFFF1 : on_process_stack_ ? 0xFFFFFFFD : 0xFFFFFFF9);
  select_stack(false);
  handlers_.push_back({exception, next_, jump_count_});
  nvic_.enter(exception);
  next_ = target & ~1u;
  clock_.now += kEntryCycles;
  asleep_ = false;
  predicated_ = 0;
  check_stack();
}

void Cpu::leave() {
  returning_ = false;
  std::uint32_t words[8];
  const bool to_process = (after_ & 0xE) == 0xC;
  if (to_process && handlers_.size() != 1) return fail(Fault::Kind::exception_return, pc_);
  select_stack(to_process);
  faultmask_ = 0;
  const std::uint32_t sp = reg(kSp);
  const std::uint8_t* const frame = ram(sp, 32);
  if (!frame || handlers_.empty()) return fail(Fault::Kind::exception_return, pc_);
  std::memcpy(words, frame, sizeof words);
  for (int i = 0; i < 4; ++i) set_reg(i, words[i]);
  set_reg(12, words[4]);
  set_reg(kLr, words[5]);
  next_ = words[6];
  set_reg(kSp, sp + 32 + (words[7] & kAligned ? 4 : 0));
  set_status(words[7]);
  forget_jumps(handlers_.back().jumps);
  nvic_.leave(handlers_.back().exception);
  handlers_.pop_back();
  clock_.now += nvic_.wakes() ? kTailChainCycles : kExitCycles;
  if (!handlers_.empty()) return;
  handler_cycles_ += clock_.now - handler_began_;
  asleep_ = nvic_.sleeps_on_exit();  // as by WFI: PM0056 2.5.1
  waits_for_event_ = false;
}

}  // namespace robosim::exec::stm32
