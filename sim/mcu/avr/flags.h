// Stores the flags of SREG in separate variables. An instruction stores only the values that determine its
// flags; a flag is computed when it is read. Source: AVR Instruction Set Manual, DS40002198B.
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {

struct Flags {
  unsigned carry = 0;     ///< 0 or 1
  unsigned zero = 0;      ///< Z is set if this variable is 0
  unsigned negative = 0;  ///< N in bit 7; bit 15 is set if S was written as other than N xor V
  unsigned overflow = 0;  ///< carries into each bit; V is the carry into bit 7 xor the carry out of bit 7
  unsigned half = 0;      ///< H in bit 4
  unsigned others = 0;    ///< T and I, at their positions in SREG

  void unpack(std::uint8_t sreg);
  constexpr void take_apart(unsigned sreg) {
    others = sreg & (Cpu::kT | Cpu::kI);
    carry = sreg & Cpu::kC;
    zero = ~sreg & Cpu::kZ;
    negative = sreg << 5 & 0x80;
    overflow = sreg << 4 & 0x80;
    negative |= ((sreg << 3 & 0x80) ^ negative ^ overflow) << 8;
    half = sreg >> 1 & 0x10;
  }
  std::uint8_t pack() const {
    return static_cast<std::uint8_t>(others | carry | (zero == 0 ? Cpu::kZ : 0u) | (negative >> 5 & Cpu::kN) |
                                     (v() >> 4 & Cpu::kV) | (sign() >> 3 & Cpu::kS) | (half << 1 & Cpu::kH));
  }
  /// Returns `sreg` with its T and I replaced by the stored T and I.
  std::uint8_t packed_into(unsigned sreg) const {
    return static_cast<std::uint8_t>((sreg & ~unsigned{Cpu::kT | Cpu::kI}) | others);
  }
  /// Returns S in bit 7.
  unsigned sign() const { return negative ^ negative >> 8 ^ v(); }
  void set(unsigned bits) { unpack(static_cast<std::uint8_t>(pack() | bits)); }
  void clear(unsigned bits) {
    if (bits & (Cpu::kT | Cpu::kI)) {
      others &= ~bits;
    } else {
      unpack(static_cast<std::uint8_t>(pack() & ~bits));
    }
  }

  std::uint8_t sum(unsigned d, unsigned s, unsigned c) {
    const unsigned wide = d + s + c;
    carry = wide >> 8;
    return arithmetic(d, s, wide);
  }
  std::uint8_t difference(unsigned d, unsigned s) { return difference_with(d, s, 0); }
  /// Subtracts a higher byte of a number, with carry. Z then covers this byte and all lower bytes.
  std::uint8_t difference_with_carry(unsigned d, unsigned s) {
    const unsigned before = zero;
    const std::uint8_t result = difference_with(d, s, carry);
    zero |= before;
    return result;
  }
  // Compute a lower byte of a number, and only the flags that the higher bytes use.
  std::uint8_t sum_below(unsigned d, unsigned s) {
    const unsigned wide = d + s + carry;
    carry = wide >> 8;
    return static_cast<std::uint8_t>(wide);
  }
  std::uint8_t difference_below(unsigned d, unsigned s) {
    const unsigned wide = d - s - carry;
    carry = wide >> 8 & 1;
    zero |= wide & 0xFF;
    return static_cast<std::uint8_t>(wide);
  }
  std::uint8_t shifted_below(unsigned d) {
    const unsigned result = d >> 1 | carry << 7;
    carry = d & 1;
    return static_cast<std::uint8_t>(result);
  }

  std::uint8_t logic(unsigned result) {
    negative = zero = result;
    overflow = 0;
    return static_cast<std::uint8_t>(result);
  }
  /// Sets the flags of INC and DEC.
  std::uint8_t counted(unsigned value, bool overflows) {
    negative = zero = value & 0xFF;
    overflow = overflows ? 0x80 : 0;
    return static_cast<std::uint8_t>(value);
  }
  /// Sets the flags of a right shift; `c` is the bit that was shifted out.
  std::uint8_t shifted(unsigned result, unsigned c) {
    carry = c;
    negative = zero = result;
    overflow = result ^ c << 7;
    return static_cast<std::uint8_t>(result);
  }
  /// Sets the flags of ADIW and SBIW; bit 16 of `after` is the carry.
  void added_word(unsigned after, bool overflows) {
    carry = after >> 16 & 1;
    zero = after & 0xFFFF;
    negative = after >> 8 & 0xFF;
    overflow = overflows ? 0x80 : 0;
  }
  void product(unsigned bits, unsigned result) {
    carry = bits >> 15 & 1;
    zero = result;
  }

 private:
  std::uint8_t difference_with(unsigned d, unsigned s, unsigned c) {
    const unsigned wide = d - s - c;
    carry = wide >> 8 & 1;
    return arithmetic(d, s, wide);
  }
  std::uint8_t arithmetic(unsigned d, unsigned s, unsigned wide) {
    negative = zero = wide & 0xFF;
    overflow = half = d ^ s ^ wide;
    return static_cast<std::uint8_t>(wide);
  }
  unsigned v() const { return overflow ^ overflow >> 1; }
};

/// Flags for each value of SREG.
inline constexpr std::array<Flags, 256> kFlagsOf = [] {
  std::array<Flags, 256> all;
  for (unsigned sreg = 0; sreg < all.size(); ++sreg) all[sreg].take_apart(sreg);
  return all;
}();

inline void Flags::unpack(std::uint8_t sreg) {
  const Flags& of = kFlagsOf[sreg];  // copies member by member: the members are in host registers
  carry = of.carry;
  zero = of.zero;
  negative = of.negative;
  overflow = of.overflow;
  half = of.half;
  others = of.others;
}

}  // namespace robosim::avr
