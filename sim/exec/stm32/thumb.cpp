#include "sim/exec/stm32/thumb.h"

namespace robosim::exec::stm32 {
namespace {

std::uint8_t bits(unsigned op, int from, int count) {
  return static_cast<std::uint8_t>(op >> from & ((1u << count) - 1));
}

Thumb with_value(Op op, std::uint8_t d, std::uint8_t n, std::uint32_t value, std::uint8_t sets = 0) {
  Thumb t;
  t.op = op;
  t.d = d;
  t.n = n;
  t.value = value;
  t.sets = sets;
  return t;
}

Thumb with_register(Op op, std::uint8_t d, std::uint8_t n, std::uint8_t m, std::uint8_t sets = 0) {
  Thumb t = with_value(op, d, n, 0, sets);
  t.m = m;
  return t;
}

// Decodes the instructions of section A5.2.1: shift by an immediate value, add, subtract, move, compare.
Thumb decode_arithmetic(unsigned op) {
  constexpr std::uint8_t kFlags = Thumb::kSetsOutside;
  const std::uint8_t d = bits(op, 0, 3), n = bits(op, 3, 3), low = bits(op, 8, 3);
  const std::uint32_t byte = op & 0xFF;
  switch (op >> 11) {
    case 0:
      if ((op >> 6 & 31) == 0) return with_register(Op::mov, d, Thumb::kZero, n, kFlags);
      [[fallthrough]];
    case 1:
    case 2: {
      Thumb t = with_register(Op::mov_shifted, d, Thumb::kZero, n, kFlags);
      t.shift = bits(op, 11, 2);
      t.value = bits(op, 6, 5);
      if (t.value == 0) t.value = 32;
      return t;
    }
    case 3: {
      const Op kind = op & 0x200 ? Op::sub : Op::add;
      if (op & 0x400) return with_value(kind, d, n, bits(op, 6, 3), kFlags);
      return with_register(kind, d, n, bits(op, 6, 3), kFlags);
    }
    case 4:
      return with_value(Op::mov, low, Thumb::kZero, byte, kFlags);
    case 5:
      return with_value(Op::cmp, 0, low, byte, Thumb::kSets);
    case 6:
      return with_value(Op::add, low, low, byte, kFlags);
    default:
      return with_value(Op::sub, low, low, byte, kFlags);
  }
}

// Decodes the instructions of section A5.2.2: operations on two registers.
Thumb decode_registers(unsigned op) {
  constexpr std::uint8_t kFlags = Thumb::kSetsOutside;
  const std::uint8_t d = bits(op, 0, 3), m = bits(op, 3, 3);
  const auto shifted = [&](Shift kind) {
    Thumb t = with_register(Op::shift, d, d, m, kFlags);
    t.shift = kind;
    return t;
  };
  switch (op >> 6 & 15) {
    case 0:
      return with_register(Op::and_, d, d, m, kFlags);
    case 1:
      return with_register(Op::eor, d, d, m, kFlags);
    case 2:
      return shifted(kLsl);
    case 3:
      return shifted(kLsr);
    case 4:
      return shifted(kAsr);
    case 5:
      return with_register(Op::adc, d, d, m, kFlags);
    case 6:
      return with_register(Op::sbc, d, d, m, kFlags);
    case 7:
      return shifted(kRor);
    case 8:
      return with_register(Op::tst, 0, d, m, Thumb::kSets);
    case 9:
      return with_value(Op::rsb, d, m, 0, kFlags);
    case 10:
      return with_register(Op::cmp, 0, d, m, Thumb::kSets);
    case 11:
      return with_register(Op::cmn, 0, d, m, Thumb::kSets);
    case 12:
      return with_register(Op::orr, d, d, m, kFlags);
    case 13:
      return with_register(Op::mul, d, d, m, kFlags);
    case 14:
      return with_register(Op::bic, d, d, m, kFlags);
    default:
      return with_register(Op::mvn, d, Thumb::kZero, m, kFlags);
  }
}

// Decodes the instructions of section A5.2.3: operations on any register, and branches to registers.
Thumb decode_high(unsigned op) {
  const std::uint8_t d = static_cast<std::uint8_t>((op & 7) | (op >> 4 & 8)), m = bits(op, 3, 4);
  switch (op >> 8 & 3) {
    case 0:
      return with_register(d >= Thumb::kSp && d != Thumb::kLr ? Op::add_high : Op::add, d, d, m);
    case 1:
      return with_register(Op::cmp, 0, d, m, Thumb::kSets);
    case 2:
      return with_register(d >= Thumb::kSp && d != Thumb::kLr ? Op::mov_high : Op::mov, d, Thumb::kZero, m);
    default:
      if (op & 7 || m == Thumb::kPc) return {};
      return with_register(op & 0x80 ? Op::blx : Op::bx, 0, Thumb::kZero, m);
  }
}

// Decodes the instructions of section A5.2.4: loads and stores.
Thumb decode_transfer(unsigned op) {
  const std::uint8_t d = bits(op, 0, 3), n = bits(op, 3, 3);
  const std::uint32_t offset = op >> 6 & 31;
  switch (op >> 12) {
    case 5: {
      constexpr Op kKinds[] = {Op::str, Op::strh, Op::strb, Op::ldrsb,
                               Op::ldr, Op::ldrh, Op::ldrb, Op::ldrsh};
      return with_register(kKinds[op >> 9 & 7], d, n, bits(op, 6, 3));
    }
    case 6:
      return with_value(op & 0x800 ? Op::ldr : Op::str, d, n, offset * 4);
    case 7:
      return with_value(op & 0x800 ? Op::ldrb : Op::strb, d, n, offset);
    case 8:
      return with_value(op & 0x800 ? Op::ldrh : Op::strh, d, n, offset * 2);
    default:
      return with_value(op & 0x800 ? Op::ldr : Op::str, bits(op, 8, 3), Thumb::kSp, (op & 0xFF) * 4);
  }
}

Thumb multiple(Op op, std::uint8_t n, std::uint32_t registers, std::uint8_t how) {
  if (registers == 0) return {};
  Thumb t = with_value(op, 0, n, registers);
  t.shift = how;
  return t;
}

// Decodes the instructions of section A5.2.5: various 16-bit instructions.
Thumb decode_various(std::uint32_t pc, unsigned op) {
  const std::uint8_t d = bits(op, 0, 3), m = bits(op, 3, 3);
  if ((op & 0x0F00) == 0)
    return with_value(op & 0x80 ? Op::sub : Op::add, Thumb::kSp, Thumb::kSp, (op & 0x7F) * 4);
  if ((op & 0x0500) == 0x0100) {
    const std::uint32_t offset = (op >> 3 & 0x1F) << 1 | (op >> 9 & 1) << 6;
    return with_value(op & 0x800 ? Op::cbnz : Op::cbz, 0, d, pc + 4 + offset);
  }
  switch (op >> 8 & 15) {
    case 0x2: {
      constexpr Op kKinds[] = {Op::sxth, Op::sxtb, Op::uxth, Op::uxtb};
      return with_register(kKinds[op >> 6 & 3], d, Thumb::kZero, m);
    }
    case 0x4:
    case 0x5:
      return multiple(Op::stm, Thumb::kSp, (op & 0xFF) | (op & 0x100) << 6, 3);
    case 0x6:
      if ((op & 0xE8) == 0x60) return with_value(Op::cps, 0, Thumb::kZero, op & 0x1F);
      return {};
    case 0xA: {
      constexpr Op kKinds[] = {Op::rev, Op::rev16, Op::other, Op::revsh};
      return with_register(kKinds[op >> 6 & 3], d, Thumb::kZero, m);
    }
    case 0xC:
    case 0xD:
      return multiple(Op::ldm, Thumb::kSp, (op & 0xFF) | (op & 0x100) << 7, 2);
    case 0xF:
      if (op & 0xF) return with_value(Op::it, 0, Thumb::kZero, op & 0xFF);
      return (op >> 4 & 15) <= 4 ? with_value(hint(op >> 4 & 15), 0, Thumb::kZero, 0) : Thumb{};
    default:
      return {};
  }
}

}  // namespace

Op hint(std::uint32_t number) {
  return number == 2 ? Op::wfe : number == 3 ? Op::wfi : number == 4 ? Op::sev : Op::nop;
}

Thumb decode_thumb(std::uint32_t pc, std::uint16_t first, std::uint16_t second) {
  const unsigned op = first;
  if (op >= 0xE800) return decode_thumb_long(pc, first, second);
  const std::uint8_t low = bits(op, 8, 3);
  switch (op >> 12) {
    case 0x0:
    case 0x1:
    case 0x2:
    case 0x3:
      return decode_arithmetic(op);
    case 0x4:
      if (op & 0x800) return with_value(Op::ldr, low, Thumb::kZero, ((pc + 4) & ~3u) + (op & 0xFF) * 4);
      return op & 0x400 ? decode_high(op) : decode_registers(op);
    case 0xA:
      if (op & 0x800) return with_value(Op::add, low, Thumb::kSp, (op & 0xFF) * 4);
      return with_value(Op::mov, low, Thumb::kZero, ((pc + 4) & ~3u) + (op & 0xFF) * 4);
    case 0xB:
      return decode_various(pc, op);
    case 0xC: {
      const bool loads = op & 0x800;
      const std::uint32_t registers = op & 0xFF;
      const bool keeps = loads && registers >> low & 1;
      return multiple(loads ? Op::ldm : Op::stm, low, registers, keeps ? 0 : 2);
    }
    case 0xD: {
      if ((op >> 8 & 15) == 15) return with_value(Op::svc, 0, Thumb::kZero, 0);
      if ((op >> 8 & 15) == 14) return {};
      const auto offset = static_cast<std::int8_t>(op & 0xFF);
      return with_value(Op::bcond, bits(op, 8, 4), Thumb::kZero,
                        pc + 4 + static_cast<std::uint32_t>(static_cast<std::int32_t>(offset)) * 2);
    }
    case 0xE: {
      const std::uint32_t offset = (op & 0x7FF) << 1;
      return with_value(Op::b, 0, Thumb::kZero, pc + 4 + offset - (offset & 0x800) * 2);
    }
    default:
      return decode_transfer(op);
  }
}

}  // namespace robosim::exec::stm32
