// Implements the interpreter's loop. Each operation ends with a jump to the code of the next operation.
#include "sim/mcu/avr/cpu.h"
#include "sim/mcu/avr/cpu_pairs.h"
#include "sim/mcu/avr/cpu_steps.h"
#include "sim/mcu/avr/flags.h"

namespace robosim::avr {
Cpu::Stop Cpu::run(Cycle until) {
  stop_ = Stop::reached;
  horizon_ = until;

  // Local variables can stay in the host's registers. Members cannot, because a store to `r` might change any
  // member.
  std::uint8_t* const r = data.data();
  const Instruction* const code = code_.data();
  const std::uint32_t words_of_flash = words_, wrap = words_ - 1;
  const Address ram_begin = ram_begin_, ram_span = static_cast<Address>(last_ram_ - ram_begin_);
  const unsigned pc_bytes = chip_.return_address_bytes;
  const Instruction* i = nullptr;
  Cycle end = 0;
  std::int64_t left = 0;  // cycles to `end`
  Flags flags;
  std::uint16_t sp = 0, watch = 0;

#define INLINE __attribute__((always_inline))
  const auto pair = [&](Address low) INLINE { return word_at(r + low); };
  const auto set_pair = [&](Address low, unsigned value) INLINE {
    r[low] = static_cast<std::uint8_t>(value);
    r[low + 1] = static_cast<std::uint8_t>(value >> 8);
  };
  const auto product = [&](int value, int shift) INLINE {
    const auto result = static_cast<std::uint16_t>(value << shift);
    flags.product(static_cast<unsigned>(value), result);
    set_pair(0, result);
  };
  const auto s8 = [&](Address at) INLINE { return static_cast<std::int8_t>(r[at]); };
  const auto program = [&](std::uint32_t address) INLINE {
    if (state.reads_signature) [[unlikely]]
      return signature_row(address);
    return address / 2 < words_of_flash ? flash_[address] : std::uint8_t{0xFF};
  };
#undef INLINE

#if !defined(__EMSCRIPTEN__)
  static const void* const kLabels[] = {
#define LABEL(name) &&L_##name,
      ROBOSIM_AVR_OPERATIONS(LABEL)
#undef LABEL
  };
#else
  Op which = Op::nop;
#endif

resume:
  flags.unpack(state.sreg);
resume_with_flags:
  end = horizon_;
  left = static_cast<std::int64_t>(end - state.cycle);
  i = code + state.pc;
  sp = state.sp;
  watch = state.sp_watch;
  DISPATCH;

#if defined(__EMSCRIPTEN__)
choose:
  switch (which) {
#define LABEL(name) \
  case Op::name:    \
    goto L_##name;
    ROBOSIM_AVR_OPERATIONS(LABEL)
#undef LABEL
  }
#endif

  OPERATION(nop, 1) NEXT(1);
  OPERATION(add, 1) r[i->a] = flags.sum(r[i->a], r[i->b], 0);
  NEXT(1);
  OPERATION(adc, 1) r[i->a] = flags.sum(r[i->a], r[i->b], flags.carry);
  NEXT(1);
  OPERATION(sub, 1) r[i->a] = flags.difference(r[i->a], r[i->b]);
  NEXT(1);
  OPERATION(sbc, 1) r[i->a] = flags.difference_with_carry(r[i->a], r[i->b]);
  NEXT(1);
  OPERATION(and_, 1) r[i->a] = flags.logic(r[i->a] & r[i->b]);
  NEXT(1);
  OPERATION(or_, 1) r[i->a] = flags.logic(r[i->a] | r[i->b]);
  NEXT(1);
  OPERATION(eor, 1) r[i->a] = flags.logic(r[i->a] ^ r[i->b]);
  NEXT(1);
  OPERATION(mov, 1) r[i->a] = r[i->b];
  NEXT(1);
  OPERATION(movw, 1) r[i->a] = r[i->b];
  r[i->a + 1] = r[i->b + 1];
  NEXT(1);
  OPERATION(cp, 1) flags.difference(r[i->a], r[i->b]);
  NEXT(1);
  OPERATION(cpc, 1) flags.difference_with_carry(r[i->a], r[i->b]);
  NEXT(1);
  OPERATION(cpse, 1) SKIP_IF(r[i->a] == r[i->b]);
  OPERATION(mul, 2) product(r[i->a] * r[i->b], 0);
  NEXT(1);
  OPERATION(muls, 2) product(s8(i->a) * s8(i->b), 0);
  NEXT(1);
  OPERATION(mulsu, 2) product(s8(i->a) * r[i->b], 0);
  NEXT(1);
  OPERATION(fmul, 2) product(r[i->a] * r[i->b], 1);
  NEXT(1);
  OPERATION(fmuls, 2) product(s8(i->a) * s8(i->b), 1);
  NEXT(1);
  OPERATION(fmulsu, 2) product(s8(i->a) * r[i->b], 1);
  NEXT(1);

  OPERATION(subi, 1) r[i->a] = flags.difference(r[i->a], i->b);
  NEXT(1);
  OPERATION(sbci, 1) r[i->a] = flags.difference_with_carry(r[i->a], i->b);
  NEXT(1);
  OPERATION(andi, 1) r[i->a] = flags.logic(r[i->a] & i->b);
  NEXT(1);
  OPERATION(ori, 1) r[i->a] = flags.logic(r[i->a] | i->b);
  NEXT(1);
  OPERATION(ldi, 1) r[i->a] = i->b;
  NEXT(1);
  OPERATION(cpi, 1) flags.difference(r[i->a], i->b);
  NEXT(1);
  OPERATION(adiw, 2) {
    const unsigned before = pair(i->a), after = before + i->b;
    set_pair(i->a, after);
    flags.added_word(after, ~before & after & 0x8000);
    NEXT(1);
  }
  OPERATION(sbiw, 2) {
    const unsigned before = pair(i->a), after = before - i->b;
    set_pair(i->a, after);
    flags.added_word(after, before & ~after & 0x8000);
    NEXT(1);
  }

  OPERATION(com, 1) r[i->a] = flags.logic(~r[i->a] & 0xFFu);
  flags.carry = 1;
  NEXT(1);
  OPERATION(neg, 1) r[i->a] = flags.difference(0, r[i->a]);
  NEXT(1);
  OPERATION(swap, 1) r[i->a] = static_cast<std::uint8_t>(r[i->a] << 4 | r[i->a] >> 4);
  NEXT(1);
  OPERATION(inc, 1) r[i->a] = flags.counted(r[i->a] + 1u, r[i->a] == 0x7F);
  NEXT(1);
  OPERATION(dec, 1) r[i->a] = flags.counted(r[i->a] - 1u, r[i->a] == 0x80);
  NEXT(1);
  OPERATION(asr, 1) r[i->a] = flags.shifted((s8(i->a) >> 1) & 0xFFu, r[i->a] & 1u);
  NEXT(1);
  OPERATION(lsr, 1) r[i->a] = flags.shifted(r[i->a] >> 1u, r[i->a] & 1u);
  NEXT(1);
  OPERATION(ror, 1) r[i->a] = flags.shifted(r[i->a] >> 1u | flags.carry << 7, r[i->a] & 1u);
  NEXT(1);
  OPERATION(bld, 1) r[i->a] = static_cast<std::uint8_t>(flags.others & kT ? r[i->a] | i->b : r[i->a] & ~i->b);
  NEXT(1);
  OPERATION(bst, 1) flags.others = r[i->a] & i->b ? flags.others | kT : flags.others & ~unsigned{kT};
  NEXT(1);

  OPERATION(push, 2) {
    if (IS_RAM(sp) && sp - 1 >= watch) [[likely]] {
      r[sp] = r[i->a];
      sp = static_cast<std::uint16_t>(sp - 1);
      NEXT(1);
    }
    PUT(1);
    push(r[i->a]);
    RESUME;
  }
  OPERATION(pop, 2) {
    sp = static_cast<std::uint16_t>(sp + 1);
    LOAD(i->a, sp, 1);
  }

  OPERATION(ld_x, 2) LOAD(i->a, pair(kXLow), 1);
  OPERATION(ldd_y, 2) LOAD(i->a, static_cast<Address>(pair(kYLow) + i->b), 1);
  OPERATION(ldd_z, 2) LOAD(i->a, static_cast<Address>(pair(kZLow) + i->b), 1);
  OPERATION(lds, 2) LOAD(i->a, static_cast<Address>(i->k), 2);
  OPERATION(lds_ram, 2) r[i->a] = r[i->k];
  NEXT(2);
  OPERATION(ld_x_inc, 2) LOAD_AND_STEP(kXLow);
  OPERATION(ld_y_inc, 2) LOAD_AND_STEP(kYLow);
  OPERATION(ld_z_inc, 2) LOAD_AND_STEP(kZLow);
  OPERATION(ld_x_dec, 2) STEP_AND_LOAD(kXLow);
  OPERATION(ld_y_dec, 2) STEP_AND_LOAD(kYLow);
  OPERATION(ld_z_dec, 2) STEP_AND_LOAD(kZLow);
  OPERATION(st_x, 2) STORE(pair(kXLow), r[i->a], 1);
  OPERATION(std_y, 2) STORE(static_cast<Address>(pair(kYLow) + i->b), r[i->a], 1);
  OPERATION(std_z, 2) STORE(static_cast<Address>(pair(kZLow) + i->b), r[i->a], 1);
  OPERATION(sts, 2) STORE(static_cast<Address>(i->k), r[i->a], 2);
  OPERATION(sts_ram, 2) r[i->k] = r[i->a];
  NEXT(2);
  OPERATION(st_x_inc, 2) STORE_AND_STEP(kXLow);
  OPERATION(st_y_inc, 2) STORE_AND_STEP(kYLow);
  OPERATION(st_z_inc, 2) STORE_AND_STEP(kZLow);
  OPERATION(st_x_dec, 2) STEP_AND_STORE(kXLow);
  OPERATION(st_y_dec, 2) STEP_AND_STORE(kYLow);
  OPERATION(st_z_dec, 2) STEP_AND_STORE(kZLow);

  OPERATION(lpm_0, 3) r[0] = program(pair(kZLow));
  NEXT(1);
  OPERATION(lpm, 3) r[i->a] = program(pair(kZLow));
  NEXT(1);
  OPERATION(lpm_inc, 3) {
    const Address at = pair(kZLow);
    set_pair(kZLow, at + 1u);
    r[i->a] = program(at);
    NEXT(1);
  }
#define FAR_Z (pair(kZLow) | static_cast<std::uint32_t>(r[kRampz]) << 16)
  OPERATION(elpm_0, 3) r[0] = program(FAR_Z);
  NEXT(1);
  OPERATION(elpm, 3) r[i->a] = program(FAR_Z);
  NEXT(1);
  OPERATION(elpm_inc, 3) {
    const std::uint32_t at = FAR_Z;
    set_pair(kZLow, at + 1);
    r[kRampz] = static_cast<std::uint8_t>((at + 1) >> 16);
    r[i->a] = program(at);
    NEXT(1);
  }

  OPERATION(in, 1) {
    if (IS_PLAIN(kPlainRead)) {
      NOTE_IO;
      r[i->a] = r[i->k];
      NEXT(1);
    }
    PUT_PLACE(1);
    r[i->a] = load_elsewhere(static_cast<Address>(i->k));
    RESUME_WITH_FLAGS;
  }
  OPERATION(in_sreg, 1) r[i->a] = flags.pack();
  NEXT(1);
  OPERATION(out_sreg, 1) OUT_SREG(NOTE_IO);
  OPERATION(prologue_out_sreg, 1) OUT_SREG();
  OPERATION(out, 1) {
    if (IS_PLAIN(kPlainWrite)) {
      NOTE_IO;
      r[i->k] = r[i->a];
      NEXT(1);
    }
    PUT_PLACE(1);
    store_elsewhere(static_cast<Address>(i->k), r[i->a]);
    if (i->k == reg::kSreg) {
      RESUME;
    }
    RESUME_WITH_FLAGS;
  }
  OPERATION(sbi, 2) {
    PUT_PLACE(1);
    write_bit(static_cast<Address>(i->k), i->b, true);
    RESUME_WITH_FLAGS;
  }
  OPERATION(cbi, 2) {
    PUT_PLACE(1);
    write_bit(static_cast<Address>(i->k), i->b, false);
    RESUME_WITH_FLAGS;
  }
  OPERATION(sbic, 1) {
    PUT_PLACE(1);
    skip_if(!(load_elsewhere(static_cast<Address>(i->k)) & i->b));
    RESUME_WITH_FLAGS;
  }
  OPERATION(sbis, 1) {
    PUT_PLACE(1);
    skip_if(load_elsewhere(static_cast<Address>(i->k)) & i->b);
    RESUME_WITH_FLAGS;
  }

  OPERATION(read_number, 0) {
    constexpr std::int64_t kCycles = 11;
    if (left <= kCycles || !waiting || *waiting) [[unlikely]]
      goto L_in_sreg;
    r[i->a] = flags.pack();
    for (int n = 0; n < 4; ++n) r[i[2 + 2 * n].a] = r[i[2 + 2 * n].k];
    left -= kCycles;
    i += kWordsOfNumberRead - 1;
    if (flags.others & kI) state.held_at = end - static_cast<Cycle>(left);
    NOTE_IO;
    NEXT(1);
  }

  OPERATION(rjmp, 2) i = code + RELATIVE(i->k);
  DISPATCH;
  OPERATION(jmp, 3) JUMP(static_cast<std::uint32_t>(i->k));
  OPERATION(ijmp, 2) JUMP(pair(kZLow));
  OPERATION(eijmp, 2) JUMP(pair(kZLow) | static_cast<std::uint32_t>(r[kEind]) << 16);
  OPERATION(rcall, 1 + pc_bytes) CALL(1, RELATIVE(i->k));
  OPERATION(call, 2 + pc_bytes) CALL(2, static_cast<std::uint32_t>(i->k));
  OPERATION(icall, 1 + pc_bytes) CALL(1, pair(kZLow));
  OPERATION(eicall, 4) CALL(1, pair(kZLow) | static_cast<std::uint32_t>(r[kEind]) << 16);
  OPERATION(ret, 2 + pc_bytes) {
    note_jump(static_cast<std::uint32_t>(i - code));
    if (pc_bytes == 2 && IS_RAM(sp + 1) && IS_RAM(sp + 2)) [[likely]] {
      const auto to = static_cast<std::uint32_t>(r[sp + 1] << 8 | r[sp + 2]);
      sp = static_cast<std::uint16_t>(sp + 2);
      JUMP(to);
    }
    PUT(1);
    const std::uint32_t to = pop_pc();
    state.pc = target_of(to);
    RESUME;
  }
  OPERATION(reti, 2 + pc_bytes) {
    note_jump(static_cast<std::uint32_t>(i - code));
    RETURN_FROM_HANDLER;
    PUT_PLACE(1);
    const std::uint32_t to = pop_pc();
    state.pc = target_of(to);
    leave_handler();
    flags.others |= kI;
    set_sreg(flags.packed_into(state.sreg));
    RESUME_WITH_FLAGS;
  }
  OPERATION(brbs, 1) BRANCH_IF(flags.pack() & i->b);
  OPERATION(brbc, 1) BRANCH_IF(!(flags.pack() & i->b));
  OPERATION(brcs, 1) BRANCH_IF(flags.carry);
  OPERATION(brcc, 1) BRANCH_IF(!flags.carry);
  OPERATION(breq, 1) BRANCH_IF(flags.zero == 0);
  OPERATION(brne, 1) BRANCH_IF(flags.zero != 0);
  OPERATION(brmi, 1) BRANCH_IF(flags.negative & 0x80);
  OPERATION(brpl, 1) BRANCH_IF(!(flags.negative & 0x80));
  OPERATION(brlt, 1) BRANCH_IF(flags.sign() & 0x80);
  OPERATION(brge, 1) BRANCH_IF(!(flags.sign() & 0x80));
  OPERATION(count_down, 1) {
    if (flags.zero == 0) {
      NEXT(1);
    }
    left -= 1;
    i = code + RELATIVE(i->k);
    const unsigned before = pair(i->a);
    const std::int64_t fit = (left - 1) / kCyclesOfCount;
    if (left > 0 && fit > 0 && before > 1) {
      const unsigned passes = fit < before - 1 ? static_cast<unsigned>(fit) : before - 1;
      const unsigned after = before - passes;
      set_pair(i->a, after);
      flags.added_word(after, (after + 1) & ~after & 0x8000);
      left -= kCyclesOfCount * passes;
    }
    DISPATCH;
  }
  CODE_OF_PAIRS
  CODE_OF_TIME_COUNT

  OPERATION(sbrc, 1) SKIP_IF(!(r[i->a] & i->b));
  OPERATION(sbrs, 1) SKIP_IF(r[i->a] & i->b);

  OPERATION(bset, 1) {
    if (i->b == kI && !(flags.others & kI)) {
      PUT_PLACE(1);
      flags.others |= kI;
      set_sreg(flags.packed_into(state.sreg));
      RESUME_WITH_FLAGS;
    }
    flags.set(i->b);
    NEXT(1);
  }
  OPERATION(bclr, 1) flags.clear(i->b);
  NEXT(1);
  OPERATION(wdr, 1) {
    PUT(1);
    on_time();
    on_wdr();
    RESUME;
  }
  OPERATION(sleep, 1) STOP(Stop::sleep, 1);
  OPERATION(break_, 1) STOP(Stop::break_, 1);
  OPERATION(spm, 1) STOP(Stop::spm, 1);
  OPERATION(mark, 0) {
    const auto pc = static_cast<std::uint32_t>(i - code);
    if (state.passing == pc) {
      state.passing = ~0u;
      GO_TO_OPERATION(unmarked_[pc]);
    }
    state.passing = pc;
    state.cycle = end - static_cast<Cycle>(left);
    state.pc = pc;
    state.sreg = flags.pack();
    state.sp = sp;
    if (marks_[pc] & kHead || !may_pass_(may_pass_self_)) return Stop::mark;
    if (horizon_ != end) return Stop::reached;
    state.passing = ~0u;
    watch = state.sp_watch;
    GO_TO_OPERATION(unmarked_[pc]);
  }
  OPERATION(illegal, 0) STOP(Stop::illegal, 0);
  OPERATION(outside, 0) STOP(Stop::outside, 0);

leave:
  // Stores the state. The program counter points to the next instruction, which has not run yet.
  state.cycle = end - static_cast<Cycle>(left);
  state.pc = static_cast<std::uint32_t>(i - code);
  state.sreg = flags.pack();
  state.sp = sp;
  return stop_;
}

}  // namespace robosim::avr
