// Defines macros for the interpreter's loop (cpu_run.cpp): pairs of instructions that run as one
// (ROBOSIM_AVR_PAIRS). The loop must stop at the horizon, which is a cycle. If the second instruction would
// start at or after the horizon, the two instructions run separately. The loop therefore never stops inside a
// pair, where some flags are not computed.
#pragma once

#include "sim/mcu/avr/cpu_steps.h"

#define PAIR(first, second, cycles)  \
  OPERATION(first##_##second, 0)     \
  if (left <= (cycles)) [[unlikely]] \
    goto L_##first;                  \
  left -= (cycles);
#define SECOND(cycles) \
  ++i;                 \
  left -= (cycles)

#define BYTES(first, second, start, low, high) \
  PAIR(first, second, 1) {                     \
    start;                                     \
    low;                                       \
    SECOND(1);                                 \
    high;                                      \
    NEXT(1);                                   \
  }
#define ADD_BYTES(first, start)                                         \
  BYTES(first, adc, start, r[i->a] = flags.sum_below(r[i->a], r[i->b]), \
        r[i->a] = flags.sum(r[i->a], r[i->b], flags.carry))
#define SUBTRACT_BYTES(first, second, start, s)                             \
  BYTES(first, second, start, r[i->a] = flags.difference_below(r[i->a], s), \
        r[i->a] = flags.difference_with_carry(r[i->a], s))
#define COMPARE_BYTES(first, start, s) \
  BYTES(first, cpc, start, flags.difference_below(r[i->a], s), flags.difference_with_carry(r[i->a], r[i->b]))
#define SHIFT_BYTES(first, start)                                  \
  BYTES(first, ror, start, r[i->a] = flags.shifted_below(r[i->a]), \
        r[i->a] = flags.shifted(r[i->a] >> 1u | flags.carry << 7, r[i->a] & 1u))

#define THEN_BRANCH(first, step, branch, taken) \
  PAIR(first, branch, 1) {                      \
    step;                                       \
    SECOND(1);                                  \
    BRANCH_IF(taken);                           \
  }
#define BRANCHES_OF_NUMBERS(first, step)          \
  THEN_BRANCH(first, step, brcs, flags.carry)     \
  THEN_BRANCH(first, step, brcc, !flags.carry)    \
  THEN_BRANCH(first, step, breq, flags.zero == 0) \
  THEN_BRANCH(first, step, brne, flags.zero != 0)
#define BRANCHES_OF_SIGNED_NUMBERS(first, step)       \
  BRANCHES_OF_NUMBERS(first, step)                    \
  THEN_BRANCH(first, step, brlt, flags.sign() & 0x80) \
  THEN_BRANCH(first, step, brge, !(flags.sign() & 0x80))

#define TWICE(one, step) \
  PAIR(one, one, 1) {    \
    step;                \
    SECOND(1);           \
    step;                \
    NEXT(1);             \
  }
#define LOAD_TWICE(one, address)       \
  PAIR(one, one, 2) {                  \
    const Address first = (address);   \
    if (!IS_RAM(first)) [[unlikely]] { \
      left += 2;                       \
      goto L_##one;                    \
    }                                  \
    r[i->a] = r[first];                \
    SECOND(2);                         \
    LOAD(i->a, address, 1);            \
  }
#define STORE_TWICE(one, address)      \
  PAIR(one, one, 2) {                  \
    const Address first = (address);   \
    if (!IS_RAM(first)) [[unlikely]] { \
      left += 2;                       \
      goto L_##one;                    \
    }                                  \
    r[first] = r[i->a];                \
    SECOND(2);                         \
    STORE(address, r[i->a], 1);        \
  }

// Runs the handler that counts millis() (TimeCount, time_count.h) in one step. Requires that nothing can
// interrupt the handler, and that the handler's pushes do not overwrite its variables. Otherwise runs the
// instructions separately.
#define CODE_OF_TIME_COUNT                                                                                \
  OPERATION(count_time, 0) {                                                                              \
    constexpr int kPushes = TimeCount::kPushes;                                                           \
    if (left <= TimeCount::kCycles + 1 || flags.others & kI || state.open_handlers == 0 || !IS_RAM(sp) || \
        sp - kPushes < time_count_->last || sp - kPushes < watch) [[unlikely]]                            \
      goto L_push_push;                                                                                   \
    left -= time_count_->count(r, sp, flags.pack());                                                      \
    i += TimeCount::kWords - 1;                                                                           \
    goto L_reti;                                                                                          \
  }

#define CODE_OF_PAIRS                                                                             \
  ADD_BYTES(add, flags.carry = 0)                                                                 \
  ADD_BYTES(adc, )                                                                                \
  SUBTRACT_BYTES(sub, sbc, flags.carry = flags.zero = 0, r[i->b])                                 \
  SUBTRACT_BYTES(sbc, sbc, , r[i->b])                                                             \
  SUBTRACT_BYTES(subi, sbci, flags.carry = flags.zero = 0, i->b)                                  \
  SUBTRACT_BYTES(sbci, sbci, , i->b)                                                              \
  COMPARE_BYTES(cp, flags.carry = flags.zero = 0, r[i->b])                                        \
  COMPARE_BYTES(cpc, , r[i->b])                                                                   \
  COMPARE_BYTES(cpi, flags.carry = flags.zero = 0, i->b)                                          \
  SHIFT_BYTES(lsr, flags.carry = 0)                                                               \
  SHIFT_BYTES(asr, flags.carry = r[i->a] >> 7)                                                    \
  SHIFT_BYTES(ror, )                                                                              \
  BRANCHES_OF_SIGNED_NUMBERS(cp, flags.difference(r[i->a], r[i->b]))                              \
  BRANCHES_OF_SIGNED_NUMBERS(cpc, flags.difference_with_carry(r[i->a], r[i->b]))                  \
  BRANCHES_OF_NUMBERS(cpi, flags.difference(r[i->a], i->b))                                       \
  THEN_BRANCH(dec, r[i->a] = flags.counted(r[i->a] - 1u, r[i->a] == 0x80), brne, flags.zero != 0) \
  THEN_BRANCH(subi, r[i->a] = flags.difference(r[i->a], i->b), brne, flags.zero != 0)             \
  TWICE(ldi, r[i->a] = i->b)                                                                      \
  TWICE(mov, r[i->a] = r[i->b])                                                                   \
  TWICE(movw, r[i->a] = r[i->b]; r[i->a + 1] = r[i->b + 1])                                       \
  PAIR(movw, lpm, 1) {                                                                            \
    r[i->a] = r[i->b];                                                                            \
    r[i->a + 1] = r[i->b + 1];                                                                    \
    SECOND(3);                                                                                    \
    r[i->a] = program(pair(kZLow));                                                               \
    NEXT(1);                                                                                      \
  }                                                                                               \
  PAIR(push, push, 2) {                                                                           \
    if (!IS_RAM(sp) || !IS_RAM(sp - 1) || sp - 2 < watch) [[unlikely]] {                          \
      left += 2;                                                                                  \
      goto L_push;                                                                                \
    }                                                                                             \
    r[sp] = r[i->a];                                                                              \
    SECOND(2);                                                                                    \
    r[sp - 1] = r[i->a];                                                                          \
    sp = static_cast<std::uint16_t>(sp - 2);                                                      \
    NEXT(1);                                                                                      \
  }                                                                                               \
  PAIR(pop, pop, 2) {                                                                             \
    if (!IS_RAM(sp + 1) || !IS_RAM(sp + 2)) [[unlikely]] {                                        \
      left += 2;                                                                                  \
      goto L_pop;                                                                                 \
    }                                                                                             \
    r[i->a] = r[sp + 1];                                                                          \
    SECOND(2);                                                                                    \
    r[i->a] = r[sp + 2];                                                                          \
    sp = static_cast<std::uint16_t>(sp + 2);                                                      \
    NEXT(1);                                                                                      \
  }                                                                                               \
  PAIR(lds_ram, lds_ram, 2) {                                                                     \
    r[i->a] = r[i->k];                                                                            \
    ++i;                                                                                          \
    SECOND(2);                                                                                    \
    r[i->a] = r[i->k];                                                                            \
    NEXT(2);                                                                                      \
  }                                                                                               \
  PAIR(sts_ram, sts_ram, 2) {                                                                     \
    r[i->k] = r[i->a];                                                                            \
    ++i;                                                                                          \
    SECOND(2);                                                                                    \
    r[i->k] = r[i->a];                                                                            \
    NEXT(2);                                                                                      \
  }                                                                                               \
  LOAD_TWICE(ldd_y, static_cast<Address>(pair(kYLow) + i->b))                                     \
  LOAD_TWICE(ldd_z, static_cast<Address>(pair(kZLow) + i->b))                                     \
  STORE_TWICE(std_y, static_cast<Address>(pair(kYLow) + i->b))                                    \
  STORE_TWICE(std_z, static_cast<Address>(pair(kZLow) + i->b))
