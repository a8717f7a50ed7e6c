// Decodes 32-bit instructions (ARMv7-M ARM, A5.3). Some instructions are not decoded, because libunicorn
// executes them: exclusive accesses, saturation of right-shifted values, and unusual uses of the stack
// pointer or the program counter.
#include <bit>

#include "sim/exec/stm32/thumb.h"

namespace robosim::exec::stm32 {
namespace {

struct Halves {
  std::uint32_t pc;
  unsigned first, second;

  std::uint8_t n() const { return first & 15; }
  std::uint8_t t() const { return second >> 12 & 15; }
  std::uint8_t d() const { return second >> 8 & 15; }
  std::uint8_t m() const { return second & 15; }
  std::uint32_t literal() const { return (pc + 4) & ~3u; }
};

bool special(std::uint8_t number) { return number == Thumb::kSp || number == Thumb::kPc; }

// Decodes the instructions of sections A5.3.11 and A5.3.1: the data operations from AND to RSB.
Thumb data_processing(const Halves& h, bool shifted) {
  constexpr Op kKinds[] = {Op::and_, Op::bic,   Op::orr, Op::orn, Op::eor,   Op::other, Op::other, Op::other,
                           Op::add,  Op::other, Op::adc, Op::sbc, Op::other, Op::sub,   Op::rsb,   Op::other};
  Thumb t;
  t.op = kKinds[h.first >> 5 & 15];
  t.n = h.n();
  t.d = h.d();
  t.sets = h.first & 0x10 ? Thumb::kSets : 0;
  if (t.op == Op::other) return {};
  if (t.d == Thumb::kPc && t.sets != 0) {
    t.op = t.op == Op::and_  ? Op::tst
           : t.op == Op::eor ? Op::teq
           : t.op == Op::add ? Op::cmn
           : t.op == Op::sub ? Op::cmp
                             : Op::other;
    t.d = 0;
  } else if (t.n == Thumb::kPc && (t.op == Op::orr || t.op == Op::orn)) {
    t.op = t.op == Op::orr ? Op::mov : Op::mvn;
    t.n = Thumb::kZero;
  }
  const bool reads_sp = t.op == Op::add || t.op == Op::sub || t.op == Op::cmp || t.op == Op::cmn;
  if (special(t.d) || t.n == Thumb::kPc || (t.n == Thumb::kSp && !reads_sp) || t.op == Op::other) return {};
  if (!shifted) return t;
  t.m = h.m();
  if (special(t.m) || h.second & 0x8000) return {};
  const unsigned amount = (h.second >> 12 & 7) << 2 | (h.second >> 6 & 3), kind = h.second >> 4 & 3;
  if (amount == 0 && kind == kLsl) return t;
  t.op = static_cast<Op>(static_cast<unsigned>(t.op) + static_cast<unsigned>(Op::mov_shifted) -
                         static_cast<unsigned>(Op::mov));
  t.shift = amount == 0 && kind == kRor ? std::uint8_t{kRrx} : static_cast<std::uint8_t>(kind);
  t.value = amount == 0 ? 32 : amount;
  return t;
}

// Decodes a data operation whose immediate value is a repeated or rotated byte (A5.3.2).
Thumb modified_immediate(const Halves& h) {
  Thumb t = data_processing(h, false);
  const std::uint32_t byte = h.second & 0xFF;
  const unsigned how = (h.first >> 10 & 1) << 4 | (h.second >> 12 & 7) << 1 | byte >> 7;
  if (how < 8) {
    constexpr std::uint32_t kRepeat[] = {1, 0x00010001, 0x01000100, 0x01010101};
    t.value = byte * kRepeat[how >> 1];
  } else {
    t.value = std::rotr(0x80u | (byte & 0x7F), static_cast<int>(how));
    t.carry = static_cast<std::uint8_t>(t.value >> 31);
  }
  return t;
}

// Decodes the instructions of section A5.3.3: plain immediate values.
Thumb plain_immediate(const Halves& h) {
  Thumb t;
  t.d = h.d();
  t.n = h.n();
  const std::uint32_t imm12 = (h.first >> 10 & 1) << 11 | (h.second >> 12 & 7) << 8 | (h.second & 0xFF);
  const unsigned lsb = (h.second >> 12 & 7) << 2 | (h.second >> 6 & 3), last = h.second & 31;
  const bool reserved = h.first & 0x400 || h.second & 0x20;
  if (special(t.d)) return {};
  switch (h.first >> 4 & 31) {
    case 0:
    case 10: {
      const bool adds = (h.first >> 4 & 31) == 0;
      t.op = adds ? Op::add : Op::sub;
      t.value = imm12;
      if (t.n != Thumb::kPc) return t;
      t.op = Op::mov;
      t.n = Thumb::kZero;
      t.value = adds ? h.literal() + imm12 : h.literal() - imm12;
      return t;
    }
    case 4:
    case 12:
      t.op = h.first & 0x80 ? Op::movt : Op::mov;
      t.n = Thumb::kZero;
      t.value = (h.first & 15u) << 12 | imm12;
      return t;
    case 16:
    case 24:
      if (reserved || special(t.n)) return {};
      t.op = h.first & 0x80 ? Op::usat : Op::ssat;
      t.shift = static_cast<std::uint8_t>(lsb);
      t.value = t.op == Op::usat ? last : last + 1;
      return t;
    case 20:
    case 28:
      if (reserved) return {};
      t.op = h.first & 0x80 ? Op::ubfx : Op::sbfx;
      t.shift = static_cast<std::uint8_t>(lsb);
      t.value = last + 1;
      return lsb + t.value > 32 || special(t.n) ? Thumb{} : t;
    case 22:
      if (reserved || last < lsb || t.n == Thumb::kSp) return {};
      t.op = Op::bfi;
      t.shift = static_cast<std::uint8_t>(lsb);
      t.value = last + 1 - lsb;
      if (t.n == Thumb::kPc) t.n = Thumb::kZero;  // BFC
      return t;
    default:
      return {};
  }
}

// Decodes the instructions of section A5.3.4: branches and control.
Thumb branch_or_control(const Halves& h) {
  Thumb t;
  const std::uint32_t s = h.first >> 10 & 1, j1 = h.second >> 13 & 1, j2 = h.second >> 11 & 1;
  const std::uint32_t low = (h.second & 0x7FF) << 1;
  if (h.second & 0x1000) {  // B, BL; the Cortex-M3 has no BLX
    t.op = h.second & 0x4000 ? Op::bl : Op::b;
    t.value = h.pc + 4 +
              ((s ? 0xFF000000u : 0) | (j1 == s) << 23 | (j2 == s) << 22 | (h.first & 0x3FFu) << 12 | low);
    return t;
  }
  if (h.second & 0x4000) return {};
  if ((h.first >> 7 & 7) != 7) {
    t.op = Op::bcond;
    t.d = h.first >> 6 & 15;
    t.value = h.pc + 4 + ((s ? 0xFFF00000u : 0) | j2 << 19 | j1 << 18 | (h.first & 0x3Fu) << 12 | low);
    return t;
  }
  t.value = h.second & 0xFF;
  if ((h.first & 0xFFF0) == 0xF380 && !special(h.n())) {
    t.op = Op::msr;
    t.n = h.n();
  } else if (h.first == 0xF3EF && !special(h.d())) {
    t.op = Op::mrs;
    t.d = h.d();
  } else if (h.first == 0xF3AF && t.value <= 4) {
    t.op = hint(t.value);
  } else if (h.first == 0xF3BF && (h.second >> 4 & 15) >= 4 && (h.second >> 4 & 15) <= 6) {
    t.op = Op::nop;
  }
  return t;
}

// Decodes the instructions of sections A5.3.5 and A5.3.6: multiple and dual loads and stores.
Thumb multiple_or_dual(const Halves& h) {
  Thumb t;
  t.n = h.n();
  const bool loads = h.first & 0x10, writes_back = h.first & 0x20, up = h.first & 0x80,
             before = h.first & 0x100;
  if (!(h.first & 0x40)) {
    const bool takes_base = h.second >> t.n & 1;
    if (up == before || t.n == Thumb::kPc || h.second & 1u << Thumb::kSp || (writes_back && takes_base))
      return {};
    if (h.second == 0 || (!loads && h.second & 1u << Thumb::kPc)) return {};
    t.op = loads ? Op::ldm : Op::stm;
    t.value = h.second;
    t.shift = static_cast<std::uint8_t>((before ? 1 : 0) | (writes_back ? 2 : 0));
    return t;
  }
  if (!before && !writes_back) {
    if ((h.first & 0xFFF0) != 0xE8D0 || (h.second & 0xFFE0) != 0xF000 || special(h.m()) || t.n == Thumb::kSp)
      return {};
    t.op = h.second & 0x10 ? Op::tbh : Op::tbb;
    t.m = h.m();
    return t;
  }
  t.op = loads ? Op::ldrd : Op::strd;
  t.d = h.t();
  t.m = h.d();
  t.value = (h.second & 0xFF) * 4;
  if (!up) t.value = 0 - t.value;
  t.shift = static_cast<std::uint8_t>((before ? 1 : 0) | (writes_back ? 2 : 0));
  if (special(t.d) || special(t.m) || (loads && t.d == t.m)) return {};
  if (writes_back && (t.n == Thumb::kPc || t.n == t.d || t.n == t.m)) return {};
  if (t.n == Thumb::kPc) {
    if (!loads) return {};
    t.n = Thumb::kZero;
    t.value += h.literal();
  }
  return t;
}

// Decodes the instructions of sections A5.3.7 to A5.3.10: loads and stores of one value.
Thumb single(const Halves& h) {
  constexpr Op kStores[] = {Op::strb, Op::strh, Op::str, Op::other};
  constexpr Op kLoads[] = {Op::ldrb, Op::ldrh, Op::ldr, Op::other};
  constexpr Op kSigned[] = {Op::ldrsb, Op::ldrsh, Op::other, Op::other};
  const bool loads = h.first & 0x10, extends = h.first & 0x100;
  const unsigned size = h.first >> 5 & 3;
  Thumb t;
  t.op = !loads ? (extends ? Op::other : kStores[size]) : extends ? kSigned[size] : kLoads[size];
  t.n = h.n();
  t.d = h.t();
  if (t.op == Op::other || t.d == Thumb::kSp || (t.d == Thumb::kPc && t.op != Op::ldr)) return {};
  if (t.n == Thumb::kPc) {
    if (!loads) return {};
    t.n = Thumb::kZero;
    t.value = h.first & 0x80 ? h.literal() + (h.second & 0xFFF) : h.literal() - (h.second & 0xFFF);
    return t;
  }
  if (h.first & 0x80) {
    t.value = h.second & 0xFFF;
    return t;
  }
  const std::uint32_t offset = h.second & 0xFF;
  if (!(h.second & 0x800)) {
    if (h.second & 0x7C0 || special(h.m())) return {};
    t.m = h.m();
    t.shift = h.second >> 4 & 3;
    return t;
  }
  const bool before = h.second & 0x400, up = h.second & 0x200, writes_back = h.second & 0x100;
  t.value = up ? offset : 0 - offset;
  if (!writes_back) return before && !up ? t : Thumb{};
  if (t.n == t.d || (t.n == Thumb::kSp && offset & 3)) return {};
  t.op = static_cast<Op>(static_cast<unsigned>(t.op) + static_cast<unsigned>(Op::ldr_back) -
                         static_cast<unsigned>(Op::ldr));
  t.shift = before ? 1 : 0;
  return t;
}

// Decodes the instructions of section A5.3.12: operations on registers.
Thumb registers(const Halves& h) {
  Thumb t;
  t.d = h.d();
  t.n = h.n();
  t.m = h.m();
  const unsigned kind = h.first >> 4 & 15, how = h.second >> 4 & 15;
  if ((h.second & 0xF000) != 0xF000 || special(t.d) || special(t.m)) return {};
  if (kind < 8 && how == 0) {
    if (special(t.n)) return {};
    t.op = Op::shift;
    t.shift = static_cast<std::uint8_t>(kind >> 1);
    t.sets = kind & 1 ? Thumb::kSets : 0;
  } else if (kind < 8 && (how & 0xC) == 8 && t.n == Thumb::kPc) {
    constexpr Op kKinds[] = {Op::sxth, Op::uxth, Op::other, Op::other,
                             Op::sxtb, Op::uxtb, Op::other, Op::other};
    t.op = kKinds[kind];
    t.value = 8 * (how & 3);
  } else if (kind == 9 && how >= 8 && how < 12 && t.n == t.m) {
    constexpr Op kKinds[] = {Op::rev, Op::rev16, Op::rbit, Op::revsh};
    t.op = kKinds[how - 8];
  } else if (kind == 11 && how == 8 && t.n == t.m) {
    t.op = Op::clz;
  }
  return t;
}

// Decodes the instructions of sections A5.3.14 and A5.3.15: multiplications.
Thumb multiply(const Halves& h) {
  Thumb t;
  t.n = h.n();
  t.m = h.m();
  const unsigned kind = h.first >> 4 & 15, how = h.second >> 4 & 15;
  if (special(t.n) || special(t.m) || special(h.d()) || h.t() == Thumb::kSp) return {};
  t.d = h.d();
  t.shift = h.t();
  if (kind == 0 && how == 0)
    t.op = h.t() == Thumb::kPc ? Op::mul : Op::mla;
  else if (kind == 0 && how == 1 && h.t() != Thumb::kPc)
    t.op = Op::mls;
  else if (kind == 9 && how == 15 && h.t() == Thumb::kPc)
    t.op = Op::sdiv;
  else if (kind == 11 && how == 15 && h.t() == Thumb::kPc)
    t.op = Op::udiv;
  if (kind < 8 || how != 0 || h.t() == Thumb::kPc || h.t() == h.d()) return t;
  t.op = kind == 8    ? Op::smull
         : kind == 10 ? Op::umull
         : kind == 12 ? Op::smlal
         : kind == 14 ? Op::umlal
                      : Op::other;
  t.d = h.t();  // the lower half
  t.shift = h.d();
  return t;
}

}  // namespace

Thumb decode_thumb_long(std::uint32_t pc, std::uint16_t first, std::uint16_t second) {
  const Halves h{pc, first, second};
  if ((first & 0xFE00) == 0xE800) return multiple_or_dual(h);
  if ((first & 0xFE00) == 0xEA00) return data_processing(h, true);
  if ((first & 0xF800) == 0xF000) {
    if (second & 0x8000) return branch_or_control(h);
    return first & 0x200 ? plain_immediate(h) : modified_immediate(h);
  }
  if ((first & 0xFE00) == 0xF800) return single(h);
  if ((first & 0xFF00) == 0xFA00) return registers(h);
  if ((first & 0xFF00) == 0xFB00) return multiply(h);
  return {};
}

}  // namespace robosim::exec::stm32
