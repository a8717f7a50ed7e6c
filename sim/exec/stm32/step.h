// Represents an instruction for the interpreter's loop (cpu_run.cpp). The kind selects code in the loop. The
// other members are the operands. A Step is created from a Thumb (thumb.h) when the instruction first runs.
// There is one Step for each halfword of flash.
#pragma once

#include <cstdint>

#include "sim/exec/stm32/cycles.h"
#include "sim/exec/stm32/thumb.h"

namespace robosim::exec::stm32 {

// The names of the kinds. An s after the name of a data operation, as in movs_i and bics, means that the kind
// sets flags. The second operand is `value` for names with _i, and r[m] for names with _r. For other data
// operations without a shift, the second operand is r[m] + value.
// clang-format off
#define ROBOSIM_STM32_STEPS(X)                                                                           \
  X(fetch) X(mark) X(emulate) X(reads_pc) X(nop) X(mov_i) X(mov_r) X(movs_i) X(movs_r) X(add_i) X(add_r) \
  X(adds_i) X(adds_r) X(sub_i) X(sub_r) X(subs_i) X(subs_r) X(cmp_i) X(cmp_r) X(and_) X(and_s) X(orr)    \
  X(orrs) X(eor) X(eors) X(bic) X(bics) X(mvn) X(mvns) X(tst) X(adc) X(adcs) X(sbc) X(sbcs) X(rsb)       \
  X(rsbs) X(cmn) X(data) X(datas) X(shifted) X(shifteds) X(lsl) X(lsls) X(lsr) X(lsrs) X(asr) X(asrs)    \
  X(and_lsl) X(and_lsr) X(and_asr) X(orr_lsl) X(orr_lsr) X(orr_asr) X(eor_lsl) X(eor_lsr) X(eor_asr)     \
  X(bic_lsl) X(bic_lsr) X(bic_asr) X(add_lsl) X(add_lsr) X(add_asr) X(sub_lsl) X(sub_lsr) X(sub_asr)     \
  X(rsb_lsl) X(rsb_lsr) X(rsb_asr) X(shift_r) X(shift_rs) X(sub_sp) X(to_sp) X(to_pc) X(movt) X(mul)     \
  X(muls) X(mla) X(mls) X(multiply_long) X(sdiv) X(udiv) X(sxtb) X(sxth) X(uxtb) X(uxth) X(clz) X(rbit)  \
  X(rev) X(rev16) X(revsh) X(sbfx) X(ubfx) X(bfi) X(ssat) X(usat) X(ldr_const) X(ldr_i) X(ldr_r) X(ldrb_i) X(ldrb_r)     \
  X(ldrh_i) X(ldrh_r) X(ldrsb) X(ldrsh) X(ldr_pc) X(str_i) X(str_r) X(strb_i) X(strb_r) X(strh_i)        \
  X(strh_r) X(ldr_back) X(ldrb_back) X(ldrh_back) X(ldrsb_back) X(ldrsh_back) X(ldr_pc_back) X(str_back) \
  X(push) X(strb_back) X(strh_back) X(ldrd) X(strd) X(ldm) X(ldm_pc) X(stm) X(b) X(beq) X(bne) X(bcs)    \
  X(bcc) X(bmi) X(bpl) X(bvs) X(bvc) X(bhi) X(bls) X(bge) X(blt) X(bgt) X(ble) X(bl) X(cbz) X(cbnz)      \
  X(branch) X(bx) X(blx) X(tbb) X(tbh) X(it) X(it_one) X(wfi) X(wfe) X(sev) X(svc) X(cps) X(msr) X(mrs)
// clang-format on

struct alignas(16) Step {
  enum class Kind : std::uint8_t {
#define ROBOSIM_STM32_NAME(name) name,
    ROBOSIM_STM32_STEPS(ROBOSIM_STM32_NAME)
#undef ROBOSIM_STM32_NAME
  };

  Kind kind = Kind::fetch;           ///< `fetch`: not decoded yet
  Kind within = Kind::fetch;         ///< the kind within an IT block, where fewer instructions set flags
  std::uint8_t d = 0, n = 0, m = 0;  ///< registers, as in Thumb
  std::uint8_t shift = 0;            ///< as in Thumb; for some kinds, the carry or an operation
  std::uint8_t ahead = 16;           ///< distance in bytes from this Step to the next instruction's Step
  std::uint8_t cycles = 1;
  std::uint32_t value = 0;
  std::uint32_t pc = 0;  ///< address of the instruction

  std::uint32_t next() const { return pc + ahead / 8u; }
};

static_assert(sizeof(Step) == 16);

/// Converts an instruction to a Step, but does not set the Step's `pc`. A branch gets the kind `branch`. Its
/// `value` is the target of the branch, and its `shift` is the Op.
Step step_of(const Thumb& thumb, const Instruction& instruction);
/// Returns the faster kind for a `branch` whose target is in flash and is not the next instruction.
Step::Kind direct_kind(const Step& branch);

}  // namespace robosim::exec::stm32
