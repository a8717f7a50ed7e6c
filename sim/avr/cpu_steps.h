// The parts of the interpreter's loop (cpu_run.cpp): macros over its local variables, since a jump to a label
// needs the label in the same function. No other file includes this.
//
//   i, code        the instruction, and that of address 0
//   left, end      cycles to `end`, which is the horizon; their difference is the present cycle
//   r, flags, sp   the registers
#pragma once

#include <cstdint>

#include "hal/board/avr_registers.h"
#include "sim/avr/cpu.h"

namespace robosim::avr {

constexpr Address kXLow = 26, kYLow = 28, kZLow = 30;
constexpr Address kRampz = 0x5B, kEind = 0x5C;
constexpr std::int64_t kCyclesOfCount = 4;  // SBIW, and BRNE that is taken

/// Reads a word by bytes, as most words are written: a processor stalls if it reads a word right after such
/// writes.
inline __attribute__((always_inline)) std::uint16_t word_at(const std::uint8_t* low) {
  unsigned first = low[0];
  asm("" : "+r"(first));  // not as one
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
// NEXT(words): the operation is done; `left` has its cycles already.
#define DISPATCH              \
  if (left <= 0) [[unlikely]] \
    goto leave;               \
  GO_TO_OPERATION(i->op)
#define NEXT(words) \
  i += (words);     \
  DISPATCH
#define OPERATION(name, cycles) L_##name : left -= (cycles);
// From here on what the processor is holds in `state`, with the program counter behind the instruction;
// RESUME goes on from there.
#define PUT(words)                                              \
  state.cycle = end - static_cast<Cycle>(left);                 \
  state.last_pc = static_cast<std::uint32_t>(i - code);         \
  state.pc = state.last_pc + static_cast<std::uint32_t>(words); \
  state.sreg = flags.pack();                                    \
  state.sp = sp
#define RESUME goto resume
// The same for what looks at no flag but I and T: the others stay where they are, and RESUME_WITH_FLAGS
// takes them up again. `state.sreg` has them at the latest when run() comes back.
#define PUT_PLACE(words)                                        \
  state.cycle = end - static_cast<Cycle>(left);                 \
  state.last_pc = static_cast<std::uint32_t>(i - code);         \
  state.pc = state.last_pc + static_cast<std::uint32_t>(words); \
  state.sreg = flags.packed_into(state.sreg);                   \
  state.sp = sp
#define RESUME_WITH_FLAGS goto resume_with_flags
// Registers without a hook for this (`read`, `write`), where no event is due: memory, but that last_io knows.
#define IS_PLAIN(way) (left > 0 && plain_[static_cast<std::size_t>(i->k)] & (way))
#define NOTE_IO                                         \
  state.last_pc = static_cast<std::uint32_t>(i - code); \
  if (state.open_handlers == 0) {                       \
    state.last_io = end - static_cast<Cycle>(left);     \
    state.last_io_pc = state.last_pc;                   \
  }
// Where it sets I while an interrupt waits, that is entered behind the next instruction.
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
// The return address is behind the instruction.
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
// RETI, where no other handler waits to be entered, and nobody wants to know.
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
// What is stored is the register before the pointer has moved, though it may be a part of it.
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
