// Defines macros for the interpreter's loop (cpu_run.cpp). The macros use local variables of the loop.
// Functions cannot replace the macros, since a computed goto needs its labels in the same function. Only
// cpu_run.cpp includes this file.
//
//   i, last        the running Step, and the previous Step
//   left, end      `left` is the number of cycles until `end`, where run_to() should stop. The present cycle
//                  is end - left
//   r, flags       the registers
//   held           usually 0. In an IT block and just after it, `held` is the number of cycles subtracted
//                  from `left` and `end`. `left` is then negative, so that the loop reaches `leave` before
//                  each instruction
#pragma once

#include <cstring>

#include "sim/exec/stm32/cpu.h"
#include "sim/exec/stm32/thumb_values.h"

#define GO_TO_STEP(what) goto* kLabels[static_cast<unsigned>(what)]
#define DISPATCH              \
  if (left <= 0) [[unlikely]] \
    goto leave;               \
  GO_TO_STEP(i->kind)
#define BEHIND reinterpret_cast<const Step*>(reinterpret_cast<const char*>(i) + i->ahead)
#define ADVANCE \
  last = i;     \
  i = BEHIND
#define NEXT \
  ADVANCE;   \
  DISPATCH
// Begins the code of an instruction and counts its cycles.
#define STEP(name, count) L_##name : left -= (count);

#define DO(name, count, what) \
  STEP(name, count) what;     \
  NEXT
#define TRY(name, count, done)                  \
  STEP(name, count) if (!(done)) goto emulated; \
  NEXT

// Decodes a Step on first use.
#define MAKE                  \
  {                           \
    there = fetched(*i);      \
    if (!there) goto nowhere; \
    i = there;                \
  }

#define NOW (end - static_cast<Cycle>(left))
// Stores the state that functions called by an instruction may read. RESUME_TIME loads the state that these
// functions may have changed.
#define PUT          \
  clock_.now = NOW;  \
  state_.pc = i->pc; \
  state_.next = i->next()
#define RESUME_TIME                                            \
  writable = writable_;                                        \
  left = static_cast<std::int64_t>(stop_ - clock_.now) - held; \
  end = clock_.now + static_cast<Cycle>(left)

#define D r[i->d]
#define N r[i->n]
#define M r[i->m]
#define B (r[i->m] + i->value)
#define SETS_CARRY \
  if (i->shift != Thumb::kCarryStays) flags.carry = i->shift

// Defines two variants of an instruction. Only the second variant sets flags.
#define LOGIC(name, expression)   \
  STEP(name, 1) D = (expression); \
  NEXT;                           \
  STEP(name##s, 1) {              \
    D = flags.logic(expression);  \
    SETS_CARRY;                   \
    NEXT;                         \
  }
#define SHIFT(name, result, shifted_out) \
  STEP(name, 1) D = (result);            \
  NEXT;                                  \
  STEP(name##s, 1) {                     \
    const std::uint32_t value = M;       \
    flags.carry = (shifted_out)&1;       \
    D = flags.logic(result);             \
    NEXT;                                \
  }

// Defines three variants of an instruction with a shifted second operand. These variants set no flags.
#define OF_SHIFTED(name, expression)  \
  STEP(name##_lsl, 1)                 \
  OF_VALUE(expression, M << i->value) \
  STEP(name##_lsr, 1)                 \
  OF_VALUE(expression, M >> i->value) \
  STEP(name##_asr, 1)                 \
  OF_VALUE(expression, static_cast<std::uint32_t>(static_cast<std::int32_t>(M) >> i->value))
#define OF_VALUE(expression, from)    \
  {                                   \
    const std::uint32_t value = from; \
    D = (expression);                 \
    NEXT;                             \
  }

// Passes a copy of the flags. If the address of `flags` itself were passed, the compiler could not keep
// `flags` in registers.
#define COMPUTE(op, b, carry, sets)                                       \
  {                                                                       \
    state_.flags = flags;                                                 \
    compute(static_cast<Op>(op), *i, (b), (carry), (sets), state_.flags); \
    flags = state_.flags;                                                 \
    NEXT;                                                                 \
  }

#define READ(bytes, address, use)                                            \
  {                                                                          \
    const std::uint32_t at = (address);                                      \
    std::uint32_t value = 0;                                                 \
    if (at - kRam <= kRamBytes - (bytes)) [[likely]] {                       \
      std::memcpy(&value, ram + (at - kRam), (bytes));                       \
    } else if (at - kFlash <= kFlashBytes - (bytes)) {                       \
      std::memcpy(&value, flash + (at - kFlash), (bytes));                   \
    } else {                                                                 \
      PUT;                                                                   \
      const std::optional<std::uint32_t> read = load_elsewhere(at, (bytes)); \
      if (!read) goto emulated;                                              \
      value = *read;                                                         \
      RESUME_TIME;                                                           \
    }                                                                        \
    use;                                                                     \
  }
#define WRITE(bytes, address, source)                          \
  {                                                            \
    const std::uint32_t at = (address), value = (source);      \
    if (at - kRam < writable) [[likely]] {                     \
      std::memcpy(ram + (at - kRam), &value, (bytes));         \
    } else {                                                   \
      PUT;                                                     \
      if (!store_elsewhere(at, (bytes), value)) goto emulated; \
      RESUME_TIME;                                             \
    }                                                          \
  }
#define READS(name, bytes, address, use) STEP(name, 2) READ(bytes, address, use) NEXT
#define WRITES(name, bytes, address, source) STEP(name, 2) WRITE(bytes, address, source) NEXT
#define SIGNED(bits) sign_extended(value, bits)
#define INDEXED (N + (M << i->shift) + i->value)
// Defines loads and stores that also change the base register. `result` may use `value` and `moved`.
#define READ_BACK(bytes, result)                     \
  {                                                  \
    const std::uint32_t moved = N + i->value;        \
    READ(bytes, i->shift ? moved : N, D = (result)); \
    N = moved;                                       \
    NEXT;                                            \
  }
#define WRITE_BACK(bytes)                     \
  {                                           \
    const std::uint32_t moved = N + i->value; \
    WRITE(bytes, i->shift ? moved : N, D);    \
    N = moved;                                \
    NEXT;                                     \
  }
#define TELL_OF_MARK         \
  {                          \
    PUT;                     \
    clock_.now += i->cycles; \
    reached(mark);           \
    clock_.now -= i->cycles; \
    RESUME_TIME;             \
  }
#define CHECK_STACK                               \
  if (r[kSp] < state_.stack_watch) [[unlikely]] { \
    PUT;                                          \
    check_stack();                                \
    RESUME_TIME;                                  \
  }

#define SET_STACK(sp) \
  {                   \
    r[kSp] = (sp);    \
    CHECK_STACK;      \
    NEXT;             \
  }
#define DIVIDE(is_signed)                                              \
  {                                                                    \
    if (M == 0 && i->m < kSp && nvic_.traps_division()) [[unlikely]] { \
      PUT;                                                             \
      fail(Fault::Kind::division, state_.pc);                          \
      RESUME_TIME;                                                     \
    }                                                                  \
    D = quotient(N, M, is_signed);                                     \
    NEXT;                                                              \
  }

#define SATURATE(least, most)                                                    \
  {                                                                              \
    const std::int64_t from = static_cast<std::int32_t>(N << i->shift);          \
    const std::int64_t result = std::clamp<std::int64_t>(from, (least), (most)); \
    if (result != from && !state_.saturated) [[unlikely]] {                      \
      state_.saturated = true;                                                   \
      idle_.interrupted();                                                       \
    }                                                                            \
    D = static_cast<std::uint32_t>(result);                                      \
    NEXT;                                                                        \
  }

#define NOTE_JUMP(pc) state_.jumps[state_.jump_count++ % state_.jumps.size()] = (pc)
// Jumps to a Step in flash other than the next Step.
#define JUMP_TO_STEP        \
  {                         \
    left -= kRefill_cycles; \
    NOTE_JUMP(i->pc);       \
    last = i;               \
    i = code + i->value;    \
    DISPATCH;               \
  }
#define BRANCH_IF(condition)   \
  if (condition) JUMP_TO_STEP; \
  NEXT
#define JUMP(address)   \
  {                     \
    target = (address); \
    goto jump;          \
  }
// Jumps like BX and POP: the lowest bit selects Thumb.
#define JUMP_AS_BX(address)                             \
  {                                                     \
    target = (address);                                 \
    if (target >= kExceptionReturn) goto leave_handler; \
    target &= ~1u;                                      \
    goto jump;                                          \
  }
#define TABLE(bytes)                                                 \
  {                                                                  \
    r[kPc] = i->pc + 4;                                              \
    std::uint32_t entry = 0;                                         \
    const std::uint8_t* const from = memory(N + (bytes)*M, (bytes)); \
    if (!from) goto emulated;                                        \
    std::memcpy(&entry, from, (bytes));                              \
    JUMP(i->next() + 2 * entry);                                     \
  }
// Skips the sleep if an interrupt that would wake the processor is pending but masked.
#define WAIT_FOR_INTERRUPT                                                                             \
  {                                                                                                    \
    if (left > 0 && nvic_.wakes() && !nvic_.next(state_.primask | state_.faultmask, state_.basepri)) { \
      NEXT;                                                                                            \
    }                                                                                                  \
    FALL_ASLEEP(false);                                                                                \
  }
#define FALL_ASLEEP(by_event)            \
  {                                      \
    falls_asleep_ = true;                \
    state_.waits_for_event = (by_event); \
    ADVANCE;                             \
    goto out;                            \
  }
