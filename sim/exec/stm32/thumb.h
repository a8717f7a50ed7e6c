// Represents a decoded instruction of the Cortex-M3 (ARMv7-M ARM, A5 to A7): its operation and registers.
//
// The second operand of most operations is `r[m] + value`. Register 16 is always 0, so that this form also
// represents operands that are only a register or only an immediate value.
#pragma once

#include <cstdint>

namespace robosim::exec::stm32 {

// A comment after the last of several related operations applies to all of them.
enum class Op : std::uint8_t {
  other,  ///< executed by libunicorn, not by the interpreter
  // r[d] = r[n] op (r[m] + value)
  mov,
  mvn,
  and_,
  orr,
  orn,
  eor,
  bic,
  add,
  adc,
  sub,
  sbc,
  rsb,
  tst,
  teq,
  cmp,
  cmn,
  // r[d] = r[n] op (r[m] shifted by value), in the order above; `shift` is the kind of shift
  mov_shifted,
  mvn_shifted,
  and_shifted,
  orr_shifted,
  orn_shifted,
  eor_shifted,
  bic_shifted,
  add_shifted,
  adc_shifted,
  sub_shifted,
  sbc_shifted,
  rsb_shifted,
  tst_shifted,
  teq_shifted,
  cmp_shifted,
  cmn_shifted,
  add_high,
  mov_high,  ///< d may be 13 or 15
  shift,     ///< r[d] = r[n] shifted by r[m]
  movt,
  mul,
  mla,
  mls,
  umull,
  smull,
  umlal,
  smlal,
  sdiv,
  udiv,
  sxtb,
  sxth,
  uxtb,
  uxth,  ///< r[d] = r[m], rotated by value and then extended
  clz,
  rbit,
  rev,
  rev16,
  revsh,  ///< r[d] = reversed r[m]
  sbfx,
  ubfx,
  bfi,  ///< r[d], r[n]; a field of `value` bits from bit `shift`
  ssat,
  usat,  ///< r[d], r[n] << shift; saturated to `value` bits
  // r[d] is loaded from, or stored to, the address r[n] + (r[m] << shift) + value
  ldr,
  ldrb,
  ldrh,
  ldrsb,
  ldrsh,
  str,
  strb,
  strh,
  // r[d] is loaded or stored. The address is r[n] + value if `shift` is 1, otherwise r[n]. Then r[n] becomes
  // r[n] + value
  ldr_back,
  ldrb_back,
  ldrh_back,
  ldrsb_back,
  ldrsh_back,
  str_back,
  strb_back,
  strh_back,
  ldrd,
  strd,  ///< r[d] and r[m] at address r[n] + value; bits of `shift`: 1 = pre-indexed, 2 = r[n] is updated
  ldm,
  stm,  ///< `value` is the set of registers; bits of `shift`: 1 = downwards, 2 = r[n] is updated
  b,
  bcond,
  bl,
  bx,
  blx,
  cbz,
  cbnz,
  tbb,
  tbh,
  it,
  nop,
  wfi,
  wfe,
  sev,
  svc,
  cps,
  msr,
  mrs
};

/// The kinds of shift, with the numbers that instructions use.
enum Shift : std::uint8_t { kLsl, kLsr, kAsr, kRor, kRrx };

struct Thumb {
  static constexpr std::uint8_t kSp = 13, kLr = 14, kPc = 15;
  static constexpr std::uint8_t kZero = 16;        ///< the register that is always 0
  static constexpr std::uint8_t kSetsOutside = 1;  ///< sets flags only outside an IT block
  static constexpr std::uint8_t kSets = 3;
  static constexpr std::uint8_t kCarryStays = 2;

  Op op = Op::other;
  std::uint8_t d = 0, n = kZero, m = kZero;
  std::uint8_t sets = 0;  ///< the instruction sets flags: bit 0 = outside an IT block, bit 1 = inside
  std::uint8_t shift = 0;
  std::uint8_t carry = kCarryStays;  ///< carry of an expanded immediate value
  std::uint32_t value = 0;           ///< for a branch, the target of the branch
};

/// Returns the operation of a hint (ARMv7-M ARM, A5.2.5): NOP, YIELD, WFE, WFI, SEV.
Op hint(std::uint32_t number);

/// Decodes the instruction at `pc`. `second` is the halfword after `first`.
Thumb decode_thumb(std::uint32_t pc, std::uint16_t first, std::uint16_t second);
/// Decodes a 32-bit instruction.
Thumb decode_thumb_long(std::uint32_t pc, std::uint16_t first, std::uint16_t second);

}  // namespace robosim::exec::stm32
