// Decodes all instructions of an AVR's flash in advance, so that the interpreter needs one jump per
// instruction. Source: AVR Instruction Set Manual, DS40002198B. The cycle counts in cpu_run.cpp are those of
// the AVRe+ core (ATmega). The AVRe core of an ATtiny has equal counts, but lacks some instructions, such as
// MUL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace robosim::avr {

// clang-format off
/// Lists pairs of frequently adjacent instructions that run as one: ONE(X, first, second) for each pair. A
/// pair saves a jump, and the computation of flags that the second instruction overwrites.
#define ROBOSIM_AVR_PAIRS(ONE, X) \
  /* bytes of a number */ \
  ONE(X, add, adc) ONE(X, adc, adc) ONE(X, sub, sbc) ONE(X, sbc, sbc) ONE(X, subi, sbci) ONE(X, sbci, sbci) \
  ONE(X, cp, cpc) ONE(X, cpc, cpc) ONE(X, cpi, cpc) ONE(X, lsr, ror) ONE(X, asr, ror) ONE(X, ror, ror) \
  /* comparisons with their branches */ \
  ONE(X, cp, brcs) ONE(X, cp, brcc) ONE(X, cp, breq) ONE(X, cp, brne) ONE(X, cp, brlt) ONE(X, cp, brge) \
  ONE(X, cpc, brcs) ONE(X, cpc, brcc) ONE(X, cpc, breq) ONE(X, cpc, brne) ONE(X, cpc, brlt) ONE(X, cpc, brge) \
  ONE(X, cpi, brcs) ONE(X, cpi, brcc) ONE(X, cpi, breq) ONE(X, cpi, brne) ONE(X, dec, brne) ONE(X, subi, brne) \
  /* copies of values */ \
  ONE(X, ldi, ldi) ONE(X, mov, mov) ONE(X, movw, movw) ONE(X, movw, lpm) ONE(X, push, push) ONE(X, pop, pop) \
  ONE(X, lds_ram, lds_ram) ONE(X, sts_ram, sts_ram) \
  ONE(X, ldd_y, ldd_y) ONE(X, ldd_z, ldd_z) ONE(X, std_y, std_y) ONE(X, std_z, std_z)
#define ROBOSIM_AVR_AS_ONE(X, first, second) X(first##_##second)

/// Lists all operations: X(name) for each.
#define ROBOSIM_AVR_OPERATIONS(X) \
  /* two registers: a = Rd, b = Rr */ \
  X(add) X(adc) X(sub) X(sbc) X(and_) X(or_) X(eor) X(mov) X(cp) X(cpc) X(cpse) X(mul) X(muls) X(mulsu) \
  X(fmul) X(fmuls) X(fmulsu) X(movw) \
  /* one register and a constant: a = Rd, b = K */ \
  X(subi) X(sbci) X(andi) X(ori) X(ldi) X(cpi) X(adiw) X(sbiw) \
  /* one register: a = Rd; bld, bst: b = the bit's mask */ \
  X(com) X(neg) X(swap) X(inc) X(asr) X(lsr) X(ror) X(dec) X(bld) X(bst) X(push) X(pop) \
  /* data memory: a = the register, b = q, k = an address */ \
  X(ld_x) X(ld_x_inc) X(ld_x_dec) X(ldd_y) X(ld_y_inc) X(ld_y_dec) X(ldd_z) X(ld_z_inc) X(ld_z_dec) X(lds) \
  X(st_x) X(st_x_inc) X(st_x_dec) X(std_y) X(st_y_inc) X(st_y_dec) X(std_z) X(st_z_inc) X(st_z_dec) X(sts) \
  /* program memory: a = the register */ \
  X(lpm_0) X(lpm) X(lpm_inc) X(elpm_0) X(elpm) X(elpm_inc) X(spm) \
  /* I/O: a = the register, b = the bit's mask, k = the data address */ \
  X(in) X(out) X(sbi) X(cbi) X(sbic) X(sbis) \
  /* jumps: k = the target's word address, or the distance; brbs, brbc, sbrc, sbrs: b = the bit's mask */ \
  X(rjmp) X(rcall) X(jmp) X(call) X(ijmp) X(icall) X(eijmp) X(eicall) X(ret) X(reti) \
  X(brbs) X(brbc) X(sbrc) X(sbrs) \
  /* the status register: b = the bit's mask */ \
  X(bset) X(bclr) \
  X(nop) X(sleep) X(wdr) X(break_) X(illegal) \
  /* pseudo-operations: a stop before a marked instruction, and addresses beyond the end of flash */ \
  X(mark) X(outside) \
  /* BRBS and BRBC for the flags that compilers use */ \
  X(brcs) X(brcc) X(breq) X(brne) X(brmi) X(brpl) X(brlt) X(brge) \
  /* LDS and STS that access RAM */ \
  X(lds_ram) X(sts_ram) \
  /* IN and OUT of SREG; prologue: OUT between the writes of SPH and SPL */ \
  X(in_sreg) X(out_sreg) X(prologue_out_sreg) \
  /* four LDS with interrupts off, as in millis(): IN Rd,SREG; CLI; LDS ...; OUT SREG,Rd */ \
  X(read_number) \
  /* BRNE back to the SBIW Rd,1 before it: a loop that counts down, executed in one step. a = Rd */ \
  X(count_down) \
  /* the handler that counts millis() (time_count.h), complete except its RETI */ \
  X(count_time) \
  ROBOSIM_AVR_PAIRS(ROBOSIM_AVR_AS_ONE, X)

enum class Op : std::uint8_t {
#define ROBOSIM_AVR_NAME(name) name,
  ROBOSIM_AVR_OPERATIONS(ROBOSIM_AVR_NAME)
#undef ROBOSIM_AVR_NAME
};
// clang-format on

struct Instruction {
  Op op = Op::illegal;
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  std::uint8_t words = 1;  ///< size in flash: 1 or 2 words
  std::int32_t k = 0;
};
static_assert(sizeof(Instruction) == 8);

/// Decodes one instruction from its first word and the next word. Reserved codes become Op::illegal.
Instruction decode(std::uint16_t word, std::uint16_t next);

/// Decodes each word of flash as if an instruction started at that word.
std::vector<Instruction> decode(std::span<const std::uint8_t> flash);

}  // namespace robosim::avr
