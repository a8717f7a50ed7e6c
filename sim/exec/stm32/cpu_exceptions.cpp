// Enters and leaves the exception handlers of the Cortex-M3 (PM0056 2.3.7).
#include <cstring>

#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kAligned = 1u << 9;
constexpr Cycle kEntryCycles = 12, kExitCycles = 10, kTailChainCycles = 6;  // DDI 0337E, 5.5, 5.6

}  // namespace

void Cpu::take_exception() {
  if (!nvic_.any_pending() || state_.fault) return;
  if (const Exception exception = nvic_.next(state_.primask | state_.faultmask, state_.basepri))
    enter(exception);
}

// Pushes r0 to r3, r12, lr, pc and xpsr on a stack aligned to 8 bytes, and starts the handler.
void Cpu::enter(Exception exception) {
  const std::uint32_t sp = reg(kSp);
  std::uint32_t psr = status() & ~kAligned;
  if (sp & 4) psr |= kAligned;
  const std::uint32_t frame_at = (sp - 32) & ~7u;
  std::uint8_t* const frame = ram(frame_at, 32);
  if (!frame) return fail(Fault::Kind::stack, state_.next);
  const std::uint32_t words[8] = {reg(0), reg(1), reg(2), reg(3), reg(12), reg(kLr), state_.next, psr};
  std::memcpy(frame, words, sizeof words);
  std::uint32_t target = 0;
  const Address vector = nvic_.vectors() + 4u * static_cast<Address>(exception);
  const Address at = vector < kFlash ? vector : vector - kFlash;
  if (at + 4 <= kFlashBytes) std::memcpy(&target, flash_ + at, 4);
  if (const std::uint8_t* in_ram = ram(vector, 4)) std::memcpy(&target, in_ram, 4);
  if ((target & 1) == 0)
    return fail(Fault::Kind::unhandled, state_.next, static_cast<std::uint32_t>(exception));
  if (state_.handlers.empty()) {
    state_.handler_began = clock_.now;
    state_.interrupted_pc = state_.next;
  }
  set_reg(kSp, frame_at);
  set_reg(kLr, !state_.handlers.empty() ? 0xFFFFFFF1 : state_.on_process_stack ? 0xFFFFFFFD : 0xFFFFFFF9);
  select_stack(false);
  state_.handlers.push_back({exception, state_.next, state_.jump_count});
  nvic_.enter(exception);
  state_.next = target & ~1u;
  clock_.now += kEntryCycles;
  state_.asleep = false;
  state_.predicated = 0;
  check_stack();
}

void Cpu::leave() {
  state_.returning = false;
  std::uint32_t words[8];
  const bool to_process = (after_ & 0xE) == 0xC;
  if (to_process && state_.handlers.size() != 1) return fail(Fault::Kind::exception_return, state_.pc);
  select_stack(to_process);
  state_.faultmask = 0;
  const std::uint32_t sp = reg(kSp);
  const std::uint8_t* const frame = ram(sp, 32);
  if (!frame || state_.handlers.empty()) return fail(Fault::Kind::exception_return, state_.pc);
  std::memcpy(words, frame, sizeof words);
  for (int i = 0; i < 4; ++i) set_reg(i, words[i]);
  set_reg(12, words[4]);
  set_reg(kLr, words[5]);
  state_.next = words[6];
  set_reg(kSp, sp + 32 + (words[7] & kAligned ? 4 : 0));
  set_status(words[7]);
  forget_jumps(state_.handlers.back().jumps);
  nvic_.leave(state_.handlers.back().exception);
  state_.handlers.pop_back();
  clock_.now += nvic_.wakes() ? kTailChainCycles : kExitCycles;
  if (!state_.handlers.empty()) return;
  state_.handler_cycles += clock_.now - state_.handler_began;
  state_.asleep = nvic_.sleeps_on_exit();  // the processor sleeps as after WFI (PM0056 2.5.1)
  state_.waits_for_event = false;
}

}  // namespace robosim::exec::stm32
