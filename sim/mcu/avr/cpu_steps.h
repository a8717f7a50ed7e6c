// Defines the steps of the interpreter's loop (cpu_run.cpp) as macros over the loop's local variables. The
// steps are not functions, because a jump to a label cannot leave its function.
//
//   i, code        the current instruction, and the instruction at address 0
//   end            the cycle at which the loop returns
//   left           number of cycles from the current cycle to `end`
//   r, flags, sp   the registers
#pragma once

#include <cstdint>

#include "hal/board/avr_registers.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {

constexpr Address kXLow = 26, kYLow = 28, kZLow = 30;
constexpr Address kRampz = 0x5B, kEind = 0x5C;
constexpr std::int64_t kCyclesOfCount = 4;  // SBIW, and a taken BRNE

/// Reads a word byte by byte, because most words are written that way. A host processor stalls if it reads a
/// whole word just after two byte writes.
inline __attribute__((always_inline)) std::uint16_t word_at(const std::uint8_t* low) {
  unsigned first = low[0];
  asm("" : "+r"(first));  // prevents the compiler from merging the reads
  return static_cast<std::uint16_t>(first | static_cast<unsigned>(low[1]) << 8);
}

}  // namespace robosim::avr

#if defined(__EMSCRIPTEN__)
#define GO_TO_OPERATION(op) \
  which = op;               \
  goto choose
#else
#define GO_TO_OPERATION(op) goto* kLabels[static_cast<unsigned>(op)]
#endif
// NEXT(words) continues after an operation. The operation's cycles are already subtracted from `left`.
#define DISPATCH              \
  if (left <= 0) [[unlikely]] \
    goto leave;               \
  GO_TO_OPERATION(i->op)
#define NEXT(words) \
  i += (words);     \
  DISPATCH
#define OPERATION(name, cycles) L_##name : left -= (cycles);
// Stores the processor's state in `state`, with the program counter after the instruction. RESUME continues
// from `state`.
#define PUT(words)                                              \
  state.cycle = end - static_cast<Cycle>(left);                 \
  state.last_pc = static_cast<std::uint32_t>(i - code);         \
  state.pc = state.last_pc + static_cast<std::uint32_t>(words); \
  state.sreg = flags.pack();                                    \
  state.sp = sp
#define RESUME goto resume
// Stores the state for code that reads no flags except I and T. The other flags stay in local variables until
// RESUME_WITH_FLAGS. When run() returns, `state.sreg` contains all flags.
#define PUT_PLACE(words)                                        \
  state.cycle = end - static_cast<Cycle>(left);                 \
  state.last_pc = static_cast<std::uint32_t>(i - code);         \
  state.pc = state.last_pc + static_cast<std::uint32_t>(words); \
  state.sreg = flags.packed_into(state.sreg);                   \
  state.sp = sp
#define RESUME_WITH_FLAGS goto resume_with_flags
// Returns whether an I/O register has no hook for this access and no event is due. Such an access only reads
// or writes the byte in memory, and updates last_io.
#define IS_PLAIN(way) (left > 0 && plain_[static_cast<std::size_t>(i->k)] & (way))
#define NOTE_IO                                         \
  state.last_pc = static_cast<std::uint32_t>(i - code); \
  if (state.open_handlers == 0) {                       \
    state.last_io = end - static_cast<Cycle>(left);     \
    state.last_io_pc = state.last_pc;                   \
  }
// Runs an OUT to SREG. If the OUT sets I while an interrupt waits, the interrupt is entered after the next
// instruction.
#define OUT_SREG(note)                                         \
  {                                                            \
    const std::uint8_t value = r[i->a];                        \
    const bool rises = value & ~flags.others & kI;             \
    if (rises && (!waiting || *waiting)) [[unlikely]] {        \
      left += 1;                                               \
      goto L_out;                                              \
    }                                                          \
    state.last_pc = static_cast<std::uint32_t>(i - code);      \
    if (rises) state.held_at = end - static_cast<Cycle>(left); \
    note;                                                      \
    flags.unpack(value);                                       \
    NEXT(1);                                                   \
  }
#define IS_RAM(address) (static_cast<Address>((address)-ram_begin) <= ram_span)

#define LOAD(to, address, words)  \
  {                               \
    const Address at = (address); \
    if (IS_RAM(at)) [[likely]] {  \
      r[to] = r[at];              \
      NEXT(words);                \
    }                             \
    if (at == reg::kSreg) {       \
      r[to] = flags.pack();       \
      NEXT(words);                \
    }                             \
    PUT_PLACE(words);             \
    r[to] = load_elsewhere(at);   \
    RESUME_WITH_FLAGS;            \
  }
#define STORE(address, value, words)     \
  {                                      \
    const Address at = (address);        \
    const std::uint8_t stored = (value); \
    if (IS_RAM(at)) [[likely]] {         \
      r[at] = stored;                    \
      NEXT(words);                       \
    }                                    \
    PUT_PLACE(words);                    \
    store_elsewhere(at, stored);         \
    if (at == reg::kSreg) {              \
      RESUME;                            \
    }                                    \
    RESUME_WITH_FLAGS;                   \
  }
// Calls a function; the return address is after the instruction.
#define CALL(words, target)                                                            \
  {                                                                                    \
    const auto back = static_cast<std::uint32_t>(i - code) + (words);                  \
    const std::uint32_t to = (target);                                                 \
    note_jump(back - (words));                                                         \
    if (pc_bytes == 2 && IS_RAM(sp) && IS_RAM(sp - 1) && sp - 2 >= watch) [[likely]] { \
      r[sp] = static_cast<std::uint8_t>(back);                                         \
      r[sp - 1] = static_cast<std::uint8_t>(back >> 8);                                \
      sp = static_cast<std::uint16_t>(sp - 2);                                         \
      i = code + (to < words_of_flash ? to : target_of(to));                           \
      DISPATCH;                                                                        \
    }                                                                                  \
    PUT(words);                                                                        \
    push_pc(back);                                                                     \
    state.pc = target_of(to);                                                          \
    RESUME;                                                                            \
  }
// Runs RETI in the common case: no other interrupt is pending, and on_left has no listener.
#define RETURN_FROM_HANDLER                                                                             \
  if (pc_bytes == 2 && IS_RAM(sp + 1) && IS_RAM(sp + 2) && waiting && !*waiting && !on_left.function) { \
    state.cycle = end - static_cast<Cycle>(left);                                                       \
    state.last_pc = static_cast<std::uint32_t>(i - code);                                               \
    leave_handler();                                                                                    \
    if (!(flags.others & kI)) state.held_at = state.cycle;                                              \
    flags.others |= kI;                                                                                 \
    const auto to = static_cast<std::uint32_t>(r[sp + 1] << 8 | r[sp + 2]);                             \
    sp = static_cast<std::uint16_t>(sp + 2);                                                            \
    JUMP(to);                                                                                           \
  }
#define JUMP(target)                                             \
  {                                                              \
    const std::uint32_t next = (target);                         \
    i = code + (next < words_of_flash ? next : target_of(next)); \
    DISPATCH;                                                    \
  }
#define STOP(why, words) \
  {                      \
    PUT(words);          \
    stop_ = (why);       \
    return stop_;        \
  }
#define RELATIVE(k) ((static_cast<std::uint32_t>(i - code) + 1 + static_cast<std::uint32_t>(k)) & wrap)
#define BRANCH_IF(taken)       \
  if (taken) {                 \
    left -= 1;                 \
    i = code + RELATIVE(i->k); \
    DISPATCH;                  \
  }                            \
  NEXT(1)
#define SKIP_IF(taken)                   \
  if (taken) {                           \
    const unsigned skipped = i[1].words; \
    left -= skipped;                     \
    NEXT(1 + skipped);                   \
  }                                      \
  NEXT(1)

#define LOAD_AND_STEP(low)             \
  {                                    \
    const Address pointer = pair(low); \
    set_pair(low, pointer + 1u);       \
    LOAD(i->a, pointer, 1);            \
  }
#define STEP_AND_LOAD(low)                                    \
  {                                                           \
    const auto pointer = static_cast<Address>(pair(low) - 1); \
    set_pair(low, pointer);                                   \
    LOAD(i->a, pointer, 1);                                   \
  }
// Stores the value that the register had before the increment, even if the register is part of the pointer.
#define STORE_AND_STEP(low)              \
  {                                      \
    const Address pointer = pair(low);   \
    const std::uint8_t before = r[i->a]; \
    set_pair(low, pointer + 1u);         \
    STORE(pointer, before, 1);           \
  }
#define STEP_AND_STORE(low)                                   \
  {                                                           \
    const auto pointer = static_cast<Address>(pair(low) - 1); \
    const std::uint8_t before = r[i->a];                      \
    set_pair(low, pointer);                                   \
    STORE(pointer, before, 1);                                \
  }
