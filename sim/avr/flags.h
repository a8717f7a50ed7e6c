// SREG, taken apart, so that an instruction writes down what its flags come from, and only who looks at a
// flag makes it. Source: AVR Instruction Set Manual, DS40002198B.
#pragma once

#include <cstdint>

#include "sim/avr/cpu.h"

namespace robosim::avr {

struct Flags {
  unsigned carry = 0;     ///< 0 or 1
  unsigned zero = 0;      ///< Z is set where this is 0
  unsigned negative = 0;  ///< N in bit 7, and so are V and S
  unsigned overflow = 0;
  unsigned sign = 0;    ///< N xor V, unless firmware has set it by itself
  unsigned half = 0;    ///< H in bit 4
  unsigned others = 0;  ///< T and I, where they are in SREG

  void unpack(unsigned sreg) {
    others = sreg & (Cpu::kT | Cpu::kI);
    carry = sreg & Cpu::kC;
    zero = ~sreg & Cpu::kZ;
    negative = sreg << 5 & 0x80;
    overflow = sreg << 4 & 0x80;
    sign = sreg << 3 & 0x80;
    half = sreg >> 1 & 0x10;
  }
  std::uint8_t pack() const {
    return static_cast<std::uint8_t>(others | carry | (zero == 0 ? Cpu::kZ : 0u) | (negative >> 5 & Cpu::kN) |
                                     (overflow >> 4 & Cpu::kV) | (sign >> 3 & Cpu::kS) |
                                     (half << 1 & Cpu::kH));
  }
  void set(unsigned bits) { unpack(pack() | bits); }
  void clear(unsigned bits) {
    if (bits & (Cpu::kT | Cpu::kI)) {
      others &= ~bits;
    } else {
      unpack(pack() & ~bits);
    }
  }

  std::uint8_t sum(unsigned d, unsigned s, unsigned c) {
    const unsigned wide = d + s + c, result = wide & 0xFF;
    carry = wide >> 8;
    return arithmetic(d, s, result, (d ^ result) & (s ^ result));
  }
  std::uint8_t difference(unsigned d, unsigned s) { return difference_with(d, s, 0); }
  /// Of the higher bytes of a number: Z is of all of them.
  std::uint8_t difference_with_carry(unsigned d, unsigned s) {
    const unsigned before = zero;
    const std::uint8_t result = difference_with(d, s, carry);
    zero |= before;
    return result;
  }
  std::uint8_t logic(unsigned result) {
    negative = zero = sign = result;
    overflow = 0;
    return static_cast<std::uint8_t>(result);
  }
  /// INC and DEC.
  std::uint8_t counted(unsigned value, bool overflows) {
    negative = zero = value & 0xFF;
    overflow = overflows ? 0x80 : 0;
    sign = negative ^ overflow;
    return static_cast<std::uint8_t>(value);
  }
  /// To the right; `c` is the bit that fell out.
  std::uint8_t shifted(unsigned result, unsigned c) {
    carry = c;
    negative = zero = result;
    overflow = result ^ c << 7;
    sign = c << 7;
    return static_cast<std::uint8_t>(result);
  }
  /// ADIW and SBIW: bit 16 of `after` is the carry.
  void added_word(unsigned after, bool overflows) {
    carry = after >> 16 & 1;
    zero = after & 0xFFFF;
    negative = after >> 8;
    overflow = overflows ? 0x80 : 0;
    sign = negative ^ overflow;
  }
  void product(unsigned bits, unsigned result) {
    carry = bits >> 15 & 1;
    zero = result;
  }

 private:
  std::uint8_t difference_with(unsigned d, unsigned s, unsigned c) {
    const unsigned wide = d - s - c, result = wide & 0xFF;
    carry = wide >> 8 & 1;
    return arithmetic(d, s, result, (d ^ s) & (d ^ result));
  }
  std::uint8_t arithmetic(unsigned d, unsigned s, unsigned result, unsigned v) {
    negative = zero = result;
    overflow = v;
    sign = result ^ v;
    half = d ^ s ^ result;
    return static_cast<std::uint8_t>(result);
  }
};

}  // namespace robosim::avr
