#include "sim/mcu/avr/decode.h"

namespace robosim::avr {
namespace {

constexpr int kIoBegin = 0x20;  // data address of I/O address 0

struct Fields {
  std::uint16_t w;
  std::uint8_t d5() const { return w >> 4 & 31; }
  std::uint8_t r5() const { return static_cast<std::uint8_t>((w >> 5 & 16) | (w & 15)); }
  std::uint8_t d4() const { return static_cast<std::uint8_t>(16 + (w >> 4 & 15)); }
  std::uint8_t k8() const { return static_cast<std::uint8_t>((w >> 4 & 0xF0) | (w & 15)); }
  std::uint8_t mask() const { return static_cast<std::uint8_t>(1 << (w & 7)); }
  std::uint8_t q() const { return static_cast<std::uint8_t>((w >> 8 & 32) | (w >> 7 & 24) | (w & 7)); }
  int io6() const { return kIoBegin + ((w >> 5 & 48) | (w & 15)); }
  int io5() const { return kIoBegin + (w >> 3 & 31); }
  int k12() const { return static_cast<std::int16_t>(w << 4) >> 4; }
  int k7() const { return static_cast<std::int8_t>(w >> 2 & 0xFE) >> 1; }
  int k22(std::uint16_t next) const { return ((w >> 3 & 0x3E) | (w & 1)) << 16 | next; }
};

Instruction two(Op op, Fields f) { return {op, f.d5(), f.r5()}; }
Instruction constant(Op op, Fields f) { return {op, f.d4(), f.k8()}; }

// Decodes 0000 .... .... ....
Instruction decode_0(Fields f) {
  switch (f.w >> 10 & 3) {
    case 1:
      return two(Op::cpc, f);
    case 2:
      return two(Op::sbc, f);
    case 3:
      return two(Op::add, f);
    default:
      break;
  }
  const auto d = static_cast<std::uint8_t>(16 + (f.w >> 4 & 7)),
             r = static_cast<std::uint8_t>(16 + (f.w & 7));
  switch (f.w >> 8) {
    case 0:
      return {f.w == 0 ? Op::nop : Op::illegal};
    case 1:
      return {Op::movw, static_cast<std::uint8_t>(2 * (f.w >> 4 & 15)),
              static_cast<std::uint8_t>(2 * (f.w & 15))};
    case 2:
      return {Op::muls, f.d4(), static_cast<std::uint8_t>(16 + (f.w & 15))};
    default:
      break;
  }
  switch (f.w & 0x88) {
    case 0x00:
      return {Op::mulsu, d, r};
    case 0x08:
      return {Op::fmul, d, r};
    case 0x80:
      return {Op::fmuls, d, r};
    default:
      return {Op::fmulsu, d, r};
  }
}

// Decodes 1001 000. and 1001 001.: loads and stores.
Instruction decode_memory(Fields f, std::uint16_t next) {
  const bool store = f.w & 0x200;
  const std::uint8_t d = f.d5();
  switch (f.w & 15) {
    case 0x0:
      return {store ? Op::sts : Op::lds, d, 0, 2, next};
    case 0x1:
      return {store ? Op::st_z_inc : Op::ld_z_inc, d};
    case 0x2:
      return {store ? Op::st_z_dec : Op::ld_z_dec, d};
    case 0x4:
      return {store ? Op::illegal : Op::lpm, d};
    case 0x5:
      return {store ? Op::illegal : Op::lpm_inc, d};
    case 0x6:
      return {store ? Op::illegal : Op::elpm, d};
    case 0x7:
      return {store ? Op::illegal : Op::elpm_inc, d};
    case 0x9:
      return {store ? Op::st_y_inc : Op::ld_y_inc, d};
    case 0xA:
      return {store ? Op::st_y_dec : Op::ld_y_dec, d};
    case 0xC:
      return {store ? Op::st_x : Op::ld_x, d};
    case 0xD:
      return {store ? Op::st_x_inc : Op::ld_x_inc, d};
    case 0xE:
      return {store ? Op::st_x_dec : Op::ld_x_dec, d};
    case 0xF:
      return {store ? Op::push : Op::pop, d};
    default:
      return {};
  }
}

// Decodes 1001 0101 .... 1000 and 1001: instructions without registers.
Instruction decode_control(Fields f) {
  switch (f.w) {
    case 0x9409:
      return {Op::ijmp};
    case 0x9419:
      return {Op::eijmp};
    case 0x9508:
      return {Op::ret};
    case 0x9509:
      return {Op::icall};
    case 0x9518:
      return {Op::reti};
    case 0x9519:
      return {Op::eicall};
    case 0x9588:
      return {Op::sleep};
    case 0x9598:
      return {Op::break_};
    case 0x95A8:
      return {Op::wdr};
    case 0x95C8:
      return {Op::lpm_0};
    case 0x95D8:
      return {Op::elpm_0};
    case 0x95E8:
      return {Op::spm};
    default:
      break;
  }
  if ((f.w & 0xFF0F) != 0x9408) return {};
  return {f.w & 0x80 ? Op::bclr : Op::bset, 0, static_cast<std::uint8_t>(1 << (f.w >> 4 & 7))};
}

// Decodes 1001 010.: instructions with one register, and control instructions.
Instruction decode_one(Fields f, std::uint16_t next) {
  const std::uint8_t d = f.d5();
  switch (f.w & 15) {
    case 0x0:
      return {Op::com, d};
    case 0x1:
      return {Op::neg, d};
    case 0x2:
      return {Op::swap, d};
    case 0x3:
      return {Op::inc, d};
    case 0x5:
      return {Op::asr, d};
    case 0x6:
      return {Op::lsr, d};
    case 0x7:
      return {Op::ror, d};
    case 0xA:
      return {Op::dec, d};
    case 0xC:
    case 0xD:
      return {Op::jmp, 0, 0, 2, f.k22(next)};
    case 0xE:
    case 0xF:
      return {Op::call, 0, 0, 2, f.k22(next)};
    case 0x8:
    case 0x9:
      return decode_control(f);
    default:
      return {};
  }
}

// Decodes 1001 .... .... ....
Instruction decode_9(Fields f, std::uint16_t next) {
  const auto pair = static_cast<std::uint8_t>(24 + 2 * (f.w >> 4 & 3));
  const auto six_bits = static_cast<std::uint8_t>((f.w >> 2 & 48) | (f.w & 15));
  switch (f.w >> 8 & 15) {
    case 0x0:
    case 0x1:
    case 0x2:
    case 0x3:
      return decode_memory(f, next);
    case 0x4:
    case 0x5:
      return decode_one(f, next);
    case 0x6:
      return {Op::adiw, pair, six_bits};
    case 0x7:
      return {Op::sbiw, pair, six_bits};
    case 0x8:
      return {Op::cbi, 0, f.mask(), 1, f.io5()};
    case 0x9:
      return {Op::sbic, 0, f.mask(), 1, f.io5()};
    case 0xA:
      return {Op::sbi, 0, f.mask(), 1, f.io5()};
    case 0xB:
      return {Op::sbis, 0, f.mask(), 1, f.io5()};
    default:
      return two(Op::mul, f);
  }
}

// Decodes 10.0 .... .... ....: loads and stores with a displacement.
Instruction decode_displaced(Fields f) {
  const bool store = f.w & 0x200, y = f.w & 8;
  return {store ? (y ? Op::std_y : Op::std_z) : (y ? Op::ldd_y : Op::ldd_z), f.d5(), f.q()};
}

// Decodes 1111 .... .... ....
Instruction decode_15(Fields f) {
  switch (f.w >> 10 & 3) {
    case 0:
      return {Op::brbs, 0, f.mask(), 1, f.k7()};
    case 1:
      return {Op::brbc, 0, f.mask(), 1, f.k7()};
    default:
      break;
  }
  if (f.w & 8) return {};
  switch (f.w >> 9 & 3) {
    case 0:
      return {Op::bld, f.d5(), f.mask()};
    case 1:
      return {Op::bst, f.d5(), f.mask()};
    case 2:
      return {Op::sbrc, f.d5(), f.mask()};
    default:
      return {Op::sbrs, f.d5(), f.mask()};
  }
}

}  // namespace

Instruction decode(std::uint16_t word, std::uint16_t next) {
  const Fields f{word};
  switch (word >> 12) {
    case 0x0:
      return decode_0(f);
    case 0x1: {
      constexpr Op kOps[] = {Op::cpse, Op::cp, Op::sub, Op::adc};
      return two(kOps[word >> 10 & 3], f);
    }
    case 0x2: {
      constexpr Op kOps[] = {Op::and_, Op::eor, Op::or_, Op::mov};
      return two(kOps[word >> 10 & 3], f);
    }
    case 0x3:
      return constant(Op::cpi, f);
    case 0x4:
      return constant(Op::sbci, f);
    case 0x5:
      return constant(Op::subi, f);
    case 0x6:
      return constant(Op::ori, f);
    case 0x7:
      return constant(Op::andi, f);
    case 0x8:
    case 0xA:
      return decode_displaced(f);
    case 0x9:
      return decode_9(f, next);
    case 0xB:
      return {word & 0x800 ? Op::out : Op::in, f.d5(), 0, 1, f.io6()};
    case 0xC:
      return {Op::rjmp, 0, 0, 1, f.k12()};
    case 0xD:
      return {Op::rcall, 0, 0, 1, f.k12()};
    case 0xE:
      return constant(Op::ldi, f);
    default:
      return decode_15(f);
  }
}

std::vector<Instruction> decode(std::span<const std::uint8_t> flash) {
  std::vector<Instruction> all(flash.size() / 2);
  const auto word = [&](std::size_t at) {
    return at < all.size() ? static_cast<std::uint16_t>(flash[2 * at] | flash[2 * at + 1] << 8)
                           : std::uint16_t{0};
  };
  for (std::size_t at = 0; at < all.size(); ++at) all[at] = decode(word(at), word(at + 1));
  return all;
}

}  // namespace robosim::avr
