// Implements the interpreter's loop: the effects of instructions (ARMv7-M ARM, A7.7). The code of each
// instruction ends with a jump to the code of the next instruction. If an instruction cannot run here, it
// changes nothing, and libunicorn executes it.
#include "sim/exec/stm32/cpu_steps.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

void Cpu::run() {
  static const void* const kLabels[] = {
#define LABEL(name) &&L_##name,
      ROBOSIM_STM32_STEPS(LABEL)
#undef LABEL
  };
  // Uses local variables for the values that every instruction needs. The compiler would have to reload
  // members after each store to `r`, because such a store could change any member.
  std::uint32_t* const r = state_.r.data();
  std::uint8_t *const ram = ram_, *const flash = flash_;
  Step* const code = code_.data();
  constexpr std::int64_t kHeld = std::int64_t{1} << 60;
  Step entered;
  entered.pc = state_.pc;
  const Step *i = step_at(state_.next), *last = &entered, *there = nullptr;
  Flags flags = state_.flags;
  std::int64_t left = 0, held = state_.it != 0 || state_.predicated != 0 || halting_ ? kHeld : 0;
  Cycle end = 0;
  std::uint32_t target = 0, writable = 0;
  bool in_block = false, left_out = false;

  if (!i) return jumped_nowhere(state_.next);
  RESUME_TIME;
  DISPATCH;

  DO(nop, i->cycles, );
  DO(mov_i, 1, D = i->value);
  DO(mov_r, 1, D = M);
  STEP(movs_i, 1) D = flags.logic(i->value);
  SETS_CARRY;
  NEXT;
  DO(movs_r, 1, D = flags.logic(M));
  DO(add_i, 1, D = N + i->value);
  DO(add_r, 1, D = N + M);
  DO(adds_i, 1, D = flags.sum(N, i->value));
  DO(adds_r, 1, D = flags.sum(N, M));
  DO(sub_i, 1, D = N - i->value);
  DO(sub_r, 1, D = N - M);
  DO(subs_i, 1, D = flags.difference(N, i->value));
  DO(subs_r, 1, D = flags.difference(N, M));
  DO(cmp_i, 1, flags.difference(N, i->value));
  DO(cmp_r, 1, flags.difference(N, M));
  LOGIC(and_, N & B)
  LOGIC(orr, N | B)
  LOGIC(eor, N ^ B)
  LOGIC(bic, N & ~B)
  LOGIC(mvn, ~B)
  STEP(tst, 1) flags.logic(N & B);
  SETS_CARRY;
  NEXT;
  DO(adc, 1, D = N + B + flags.carry);
  DO(adcs, 1, D = flags.sum_with_carry(N, B));
  DO(sbc, 1, D = N + ~B + flags.carry);
  DO(sbcs, 1, D = flags.sum_with_carry(N, ~B));
  DO(rsb, 1, D = B - N);
  DO(rsbs, 1, D = flags.difference(B, N));
  DO(cmn, 1, flags.sum(N, B));
  STEP(data, 1) COMPUTE(i->shift >> 2, B, flags.carry, false);
  STEP(datas, 1) {
    const unsigned carry = i->shift & 3u;
    COMPUTE(i->shift >> 2, B, carry == Thumb::kCarryStays ? flags.carry : carry, true);
  }
  STEP(shifted, 1) {
    std::uint32_t carry = flags.carry;
    const std::uint32_t b = stm32::shifted(i->shift & 7u, M, i->value, carry);
    COMPUTE(i->shift >> 3, b, carry, false);
  }
  STEP(shifteds, 1) {
    std::uint32_t carry = flags.carry;
    const std::uint32_t b = stm32::shifted(i->shift & 7u, M, i->value, carry);
    COMPUTE(i->shift >> 3, b, carry, true);
  }
  SHIFT(lsl, M << i->value, value >> (32 - i->value))
  SHIFT(lsr, M >> i->value, value >> (i->value - 1))
  SHIFT(asr, static_cast<std::uint32_t>(static_cast<std::int32_t>(M) >> i->value), value >> (i->value - 1))
  OF_SHIFTED(and, N & value)
  OF_SHIFTED(orr, N | value)
  OF_SHIFTED(eor, N ^ value)
  OF_SHIFTED(bic, N & ~value)
  OF_SHIFTED(add, N + value)
  OF_SHIFTED(sub, N - value)
  OF_SHIFTED(rsb, value - N)
  STEP(shift_r, 1) {
    std::uint32_t carry = 0;
    const unsigned amount = M & 0xFF;
    D = amount == 0 ? N : stm32::shifted(i->shift, N, amount, carry);
    NEXT;
  }
  STEP(shift_rs, 1) {
    std::uint32_t carry = flags.carry;
    const unsigned amount = M & 0xFF;
    D = flags.logic(amount == 0 ? N : stm32::shifted(i->shift, N, amount, carry));
    flags.carry = carry;
    NEXT;
  }
  STEP(sub_sp, 1) SET_STACK(N - B);
  STEP(to_sp, 1) SET_STACK((N + M) & ~3u);
  STEP(to_pc, 1) JUMP((N + M) & ~1u);
  DO(movt, 1, D = (D & 0xFFFF) | i->value << 16);
  DO(mul, 1, D = N * M);
  DO(muls, 1, D = flags.logic(N * M));
  DO(mla, 2, D = N * M + r[i->shift]);
  DO(mls, 2, D = r[i->shift] - N * M);
  DO(multiply_long, i->cycles, multiply_long(*i));
  STEP(sdiv, 7) DIVIDE(true);
  STEP(udiv, 7) DIVIDE(false);
  DO(sxtb, 1, D = sign_extended(std::rotr(M, static_cast<int>(i->value)), 8));
  DO(sxth, 1, D = sign_extended(std::rotr(M, static_cast<int>(i->value)), 16));
  DO(uxtb, 1, D = std::rotr(M, static_cast<int>(i->value)) & 0xFF);
  DO(uxth, 1, D = std::rotr(M, static_cast<int>(i->value)) & 0xFFFF);
  DO(clz, 1, D = static_cast<std::uint32_t>(std::countl_zero(M)));
  DO(rbit, 1, D = reversed(M));
  DO(rev, 1, D = __builtin_bswap32(M));
  DO(rev16, 1, D = std::rotr(__builtin_bswap32(M), 16));
  DO(revsh, 1, D = sign_extended(__builtin_bswap32(M) >> 16, 16));
  DO(sbfx, 1, D = sign_extended(N >> i->shift, i->value));
  DO(ubfx, 1, D = N >> i->shift & (0xFFFFFFFFu >> (32 - i->value)));
  STEP(bfi, 1) {
    const std::uint32_t mask = 0xFFFFFFFFu >> (32 - i->value) << i->shift;
    D = (D & ~mask) | (N << i->shift & mask);
    NEXT;
  }

  STEP(ssat, 1) SATURATE(-(std::int64_t{1} << (i->value - 1)), (std::int64_t{1} << (i->value - 1)) - 1);
  STEP(usat, 1) SATURATE(0, (std::int64_t{1} << i->value) - 1);
  DO(ldr_const, 2, D = i->value);
  READS(ldr_i, 4, N + i->value, D = value);
  READS(ldr_r, 4, INDEXED, D = value);
  READS(ldrb_i, 1, N + i->value, D = value);
  READS(ldrb_r, 1, INDEXED, D = value);
  READS(ldrh_i, 2, N + i->value, D = value);
  READS(ldrh_r, 2, INDEXED, D = value);
  READS(ldrsb, 1, INDEXED, D = SIGNED(8));
  READS(ldrsh, 2, INDEXED, D = SIGNED(16));
  WRITES(str_i, 4, N + i->value, D);
  WRITES(str_r, 4, INDEXED, D);
  WRITES(strb_i, 1, N + i->value, D);
  WRITES(strb_r, 1, INDEXED, D);
  WRITES(strh_i, 2, N + i->value, D);
  WRITES(strh_r, 2, INDEXED, D);
  STEP(ldr_back, 2) READ_BACK(4, value);
  STEP(ldrb_back, 2) READ_BACK(1, value);
  STEP(ldrh_back, 2) READ_BACK(2, value);
  STEP(ldrsb_back, 2) READ_BACK(1, SIGNED(8));
  STEP(ldrsh_back, 2) READ_BACK(2, SIGNED(16));
  STEP(str_back, 2) WRITE_BACK(4);
  STEP(push, 2) {
    const std::uint32_t moved = N + i->value;
    WRITE(4, i->shift ? moved : N, D);
    SET_STACK(moved);
  }
  STEP(strb_back, 2) WRITE_BACK(1);
  STEP(strh_back, 2) WRITE_BACK(2);
  STEP(ldr_pc, 2) {
    if (!load_target(INDEXED, target)) goto emulated;
    JUMP_AS_BX(target);
  }
  STEP(ldr_pc_back, 2) {
    const std::uint32_t moved = N + i->value;
    if (!load_target(i->shift ? moved : N, target)) goto emulated;
    N = moved;
    JUMP_AS_BX(target);
  }
  TRY(ldrd, 3, load_two(*i));
  TRY(ldm, i->cycles, load_many(*i, i->value));
  STEP(ldm_pc, i->cycles) {
    const std::uint32_t from = i->shift & 1 ? N : N + 4 * (i->cycles - 1u);
    if (!load_target(from - 4, target) || !load_many(*i, i->value & 0x7FFF)) goto emulated;
    JUMP_AS_BX(target);
  }
  STEP(strd, 3) {
    if (!store_two(*i)) goto emulated;
    CHECK_STACK;
    NEXT;
  }
  STEP(stm, i->cycles) {
    if (!store_many(*i)) goto emulated;
    CHECK_STACK;
    NEXT;
  }

  STEP(b, 1) JUMP_TO_STEP;
  STEP(beq, 1) BRANCH_IF(flags.zero());
  STEP(bne, 1) BRANCH_IF(!flags.zero());
  STEP(bcs, 1) BRANCH_IF(flags.carry);
  STEP(bcc, 1) BRANCH_IF(!flags.carry);
  STEP(bmi, 1) BRANCH_IF(flags.sign < 0);
  STEP(bpl, 1) BRANCH_IF(flags.sign >= 0);
  STEP(bvs, 1) BRANCH_IF(flags.overflow >> 31);
  STEP(bvc, 1) BRANCH_IF(!(flags.overflow >> 31));
  STEP(bhi, 1) BRANCH_IF(flags.carry && !flags.zero());
  STEP(bls, 1) BRANCH_IF(!flags.carry || flags.zero());
  STEP(bge, 1) BRANCH_IF(!flags.less());
  STEP(blt, 1) BRANCH_IF(flags.less());
  STEP(bgt, 1) BRANCH_IF(!flags.less() && !flags.zero());
  STEP(ble, 1) BRANCH_IF(flags.less() || flags.zero());
  STEP(bl, 1) r[kLr] = i->next() | 1;
  JUMP_TO_STEP;
  STEP(cbz, 1) BRANCH_IF(N == 0);
  STEP(cbnz, 1) BRANCH_IF(N != 0);
  STEP(branch, 1) {
    const Op op = static_cast<Op>(i->shift);
    if (op == Op::bl) r[kLr] = i->next() | 1;
    const bool jumps = op == Op::bcond  ? flags.passes(i->d)
                       : op == Op::cbz  ? N == 0
                       : op == Op::cbnz ? N != 0
                                        : true;
    if (jumps) JUMP(i->value);
    NEXT;
  }
  STEP(bx, 1) {
    if (!(M & 1)) goto emulated;
    JUMP_AS_BX(M);
  }
  STEP(blx, 1) {
    target = M;
    if (!(target & 1)) goto emulated;
    r[kLr] = i->next() | 1;
    JUMP_AS_BX(target);
  }
  STEP(tbb, 2) TABLE(1);
  STEP(tbh, 2) TABLE(2);

  STEP(it_one, 1) {
    // Handles an IT block with one instruction. The instruction runs even if no cycles are left.
    if (held != 0 || halting_) goto block;
    const bool passes = flags.passes(i->value >> 4);
    ADVANCE;
    if (i->kind == Step::Kind::fetch || i->kind == Step::Kind::mark) [[unlikely]] {
      i = last;
      goto block;
    }
    if (passes) GO_TO_STEP(i->within);
    NOTE_JUMP(last->pc);
    left -= kRefill_cycles;
    i = BEHIND;
    GO_TO_STEP(i->kind);
  }
  STEP(it, 1) {
  block:
    state_.it = i->value;
    state_.predicated = i->n;
    if (held == 0) {
      held = kHeld;
      left -= held;
      end -= static_cast<Cycle>(held);
    }
    NEXT;
  }
  STEP(wfi, 1) WAIT_FOR_INTERRUPT;
  STEP(wfe, 1) {
    if (!nvic_.take_event()) FALL_ASLEEP(true);
    idle_.interrupted();
    NEXT;
  }
  DO(sev, 1, (nvic_.set_event(), idle_.interrupted()));
  STEP(svc, 1) {
    nvic_.pend(kSvcall);
    ADVANCE;
    goto out;
  }
  STEP(cps, 2) {
    PUT;
    change_masks(i->value);
    RESUME_TIME;
    NEXT;
  }
  STEP(msr, 2) {
    PUT;
    state_.flags = flags;
    if (!write_special(i->value, N)) goto emulated;
    flags = state_.flags;
    check_stack();
    masks_changed();
    RESUME_TIME;
    NEXT;
  }
  TRY(mrs, 2, (state_.flags = flags, read_special(i->value, D)));

L_reads_pc:
  r[kPc] = i->pc + 4;
  GO_TO_STEP(i->shift);

jump:
  // Jumps to any address. Continuing with the next instruction does not count as a jump.
  if (target != i->next()) {
    there = target - kFlash < kFlashBytes ? code + (target - kFlash) / 2 : step_at(target);
    if (!there) [[unlikely]] {
      PUT;
      goto lost;
    }
    left -= kRefill_cycles;
    NOTE_JUMP(i->pc);
    last = i;
    i = there;
    DISPATCH;
  }
  NEXT;

leave_handler:
  PUT;
  state_.flags = flags;
  after_ = target & ~1u;
  state_.returning = true;
  return;

  STEP(emulate, i->cycles)
emulated:
  PUT;
  state_.flags = flags;
  emulate();
  flags = state_.flags;
  if (ends_) return;
  RESUME_TIME;
  entered.pc = state_.pc;
  last = &entered;
  if (after_ != state_.next) {
    left -= kRefill_cycles;
    note_jump();
  }
  target = after_;
  i = step_at(target);
  if (!i) goto lost;
  DISPATCH;

L_fetch:
  MAKE;
  GO_TO_STEP(in_block ? i->within : i->kind);

L_mark : {
  const Mark mark = *mark_at(i->pc);
  if (held == 0 && (halting_ || mark.breaks) && halts_at(i->pc)) goto out;
  if (mark.head && held == 0) {
    clock_.now = NOW;
    state_.flags = flags;
    idle_.at_head(i->pc);
    RESUME_TIME;
  }
  if (mark.is_told()) TELL_OF_MARK;
  GO_TO_STEP(in_block ? mark.within : mark.kind);
}

leave:
  if (held == 0) goto out;
  if (i->kind == Step::Kind::fetch) MAKE;
  {
    const std::uint32_t it = state_.it;
    const std::uint32_t rest = it & 7 ? (it & 0xE0) | (it << 1 & 0x1F) : 0;
    if (it != 0 && !flags.passes(it >> 4)) {
      // A skipped instruction takes no time. The pipeline is refilled once after one or more skipped
      // instructions.
      state_.it = rest;
      left_out = true;
      i = BEHIND;
      goto leave;
    }
    if (std::exchange(left_out, false)) {
      left -= kRefill_cycles;
      NOTE_JUMP(last->pc);
    }
    if (left + held <= 0 && (state_.predicated == 0 || state_.fault)) goto out;
    in_block = it != 0;
    if (state_.predicated == 0 && !in_block && !halting_) {
      left += held;
      end += static_cast<Cycle>(held);
      held = 0;
      GO_TO_STEP(i->kind);
    }
    if ((halting_ || i->kind == Step::Kind::mark) && halts_at(i->pc)) goto out;
    state_.it = rest;
    if (state_.predicated > 0) --state_.predicated;
    GO_TO_STEP(in_block ? i->within : i->kind);
  }

nowhere:
  state_.pc = last->pc;
  target = i->pc;
lost:
  clock_.now = NOW;
  state_.flags = flags;
  return jumped_nowhere(target);

out:
  clock_.now = NOW;
  state_.pc = last->pc;
  state_.next = i->pc;
  state_.flags = flags;
}

}  // namespace robosim::exec::stm32
