#include "sim/exec/stm32/cycles.h"

namespace robosim::exec::stm32 {
namespace {

std::uint8_t count_bits(unsigned bits) { return static_cast<std::uint8_t>(__builtin_popcount(bits)); }

std::uint8_t cycles(unsigned n) { return static_cast<std::uint8_t>(n); }

// Returns the number of instructions in an IT block. The lowest set bit of the mask shows this number
// (ARMv7-M ARM, A7.7.37).
std::uint8_t length_of_it(unsigned mask) { return static_cast<std::uint8_t>(4 - __builtin_ctz(mask)); }

Instruction decode_short(unsigned op) {
  Instruction i;
  switch (op >> 12) {
    case 0x4:
      if (op >> 11 == 0x9) i.cycles = 2;                                         // LDR (literal)
      if ((op & 0xFF87) == 0x4685) i.grows_stack = true;                         // MOV sp, r
      if ((op & 0xFF00) == 0x4400 && (op & 0x87) == 0x85) i.grows_stack = true;  // ADD sp, r
      break;
    case 0x5:
    case 0x6:
    case 0x7:
    case 0x8:
    case 0x9:
      i.cycles = 2;  // loads and stores
      break;
    case 0xB:
      if ((op & 0xFF80) == 0xB080) i.grows_stack = true;  // SUB sp, #n
      if ((op & 0xF600) == 0xB400) {                      // PUSH, POP
        i.cycles = cycles(1u + count_bits(op & 0x1FF));
        i.grows_stack = !(op & 0x0800);
      }
      if ((op & 0xFFE8) == 0xB660) {  // CPS
        i.cycles = 2;
        i.masks = true;
      }
      if ((op & 0xFF00) == 0xBF00) {
        if (op & 0xF) i.predicates = length_of_it(op & 0xF);
        i.sleeps = op == 0xBF20 || op == 0xBF30;
      }
      break;
    case 0xC:
      i.cycles = cycles(1u + count_bits(op & 0xFF));  // LDM, STM
      break;
    default:
      break;
  }
  return i;
}

Instruction decode_multiply_or_divide(unsigned first, unsigned second) {
  Instruction i;
  const unsigned kind = first >> 4 & 7;
  if ((first & 0xFF80) == 0xFB00) {
    i.cycles = kind == 0 && second >> 12 == 0xF ? 1 : 2;  // MUL; MLA, MLS
  } else if (kind == 1 || kind == 3) {                    // SDIV, UDIV
    i.cycles = 7;
    i.divides = true;
    i.divisor = static_cast<std::uint8_t>(second & 0xF);
  } else {
    i.cycles = kind >= 4 ? 6 : 4;  // 6 for UMLAL and SMLAL
  }
  return i;
}

// Decodes the load or store of one word, halfword or byte (ARMv7-M ARM, A5.3.7 to A5.3.10).
Instruction decode_single(unsigned first, unsigned second) {
  Instruction i;
  i.cycles = 2;
  const bool store_on_stack = (first & 0xFF1F) == 0xF80D;
  const bool writes_back = (second & 0x0D00) == 0x0D00 || (second & 0x0F00) == 0x0900;
  i.grows_stack = store_on_stack && writes_back;
  return i;
}

Instruction decode_long(unsigned first, unsigned second) {
  Instruction i;
  if ((first & 0xFE40) == 0xE800) {  // LDM, STM, and PUSH and POP of several registers
    i.cycles = cycles(1u + count_bits(second));
    i.grows_stack = (first & 0xF) == 13 && !(first & 0x10);
  } else if ((first & 0xFE40) == 0xE840) {
    const bool table = (first & 0xFFF0) == 0xE8D0 && (second & 0xFFE0) == 0xF000;
    const bool exclusive = (first & 0xFF60) == 0xE840 && !table;
    i.cycles = table || exclusive ? 2 : 3;  // TBB; LDREX; LDRD
    i.grows_stack = (first & 0xF) == 13 && first & 0x20 && !(first & 0x10);
  } else if ((first & 0xFE00) == 0xF800) {
    i = decode_single(first, second);
  } else if ((first & 0xFF00) == 0xFB00) {
    i = decode_multiply_or_divide(first, second);
  } else if ((first & 0xF800) == 0xF000 && (second & 0xD000) == 0x8000) {
    if ((first & 0xFFE0) == 0xF380 || (first & 0xFFE0) == 0xF3E0) {  // MSR, MRS
      i.cycles = 2;
      i.masks = (first & 0xFFE0) == 0xF380;
      i.grows_stack = i.masks;
    }
    if ((first & 0xFFF0) == 0xF3B0) i.cycles = 4;  // barriers
    if (first == 0xF3AF) i.sleeps = (second & 0xFE) == 0x02;
  } else if ((first & 0xFBEF) == 0xF1AD || (first & 0xFBFF) == 0xF2AD || (first & 0xFFEF) == 0xEBAD) {
    i.grows_stack = (second >> 8 & 0xF) == 13;  // SUB.W sp, sp
  }
  i.bytes = 4;
  return i;
}

}  // namespace

Instruction decode(std::uint16_t first, std::uint16_t second) {
  return (first & 0xF800) >= 0xE800 ? decode_long(first, second) : decode_short(first);
}

}  // namespace robosim::exec::stm32
