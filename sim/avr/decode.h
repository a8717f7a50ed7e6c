// Instructions of the AVR, decoded once when flash is written: what the interpreter then does for each is one
// jump. Source: AVR Instruction Set Manual, DS40002198B; the numbers of cycles are those of the AVRe+ core
// (ATmega, ATtiny with AVRe: no MUL).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace robosim::avr {

// clang-format off
enum class Op : std::uint8_t {
  // two registers: a = Rd, b = Rr
  add, adc, sub, sbc, and_, or_, eor, mov, cp, cpc, cpse, mul, muls, mulsu, fmul, fmuls, fmulsu, movw,
  // a register and a constant: a = Rd, b = K
  subi, sbci, andi, ori, ldi, cpi, adiw, sbiw,
  // a register: a = Rd
  com, neg, swap, inc, asr, lsr, ror, dec, bld, bst, push, pop,  // bld, bst: b = the bit's mask
  // data memory: a = the register, b = q, k = an address
  ld_x, ld_x_inc, ld_x_dec, ldd_y, ld_y_inc, ld_y_dec, ldd_z, ld_z_inc, ld_z_dec, lds,
  st_x, st_x_inc, st_x_dec, std_y, st_y_inc, st_y_dec, std_z, st_z_inc, st_z_dec, sts,
  // program memory: a = the register
  lpm_0, lpm, lpm_inc, elpm_0, elpm, elpm_inc, spm,
  // I/O: a = the register, b = the bit's mask, k = the data address
  in, out, sbi, cbi, sbic, sbis,
  // jumps: k = the target's word address, or how far (signed); brbs, brbc, sbrc, sbrs: b = the bit's mask
  rjmp, rcall, jmp, call, ijmp, icall, eijmp, eicall, ret, reti, brbs, brbc, sbrc, sbrs,
  // the status register: b = the bit's mask
  bset, bclr,
  nop, sleep, wdr, break_, illegal,
  // none of the chip's: a mark in front of an instruction, and what is behind the flash
  mark, outside,
};
// clang-format on

struct Instruction {
  Op op = Op::illegal;
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  std::uint8_t words = 1;  ///< it takes in flash: 1 or 2
  std::int32_t k = 0;
};
static_assert(sizeof(Instruction) == 8);

/// One instruction, given its first word and the one behind it. What is reserved is Op::illegal.
Instruction decode(std::uint16_t word, std::uint16_t next);

/// Each word of flash, as if an instruction began there.
std::vector<Instruction> decode(std::span<const std::uint8_t> flash);

}  // namespace robosim::avr
