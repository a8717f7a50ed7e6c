#include "sim/exec/stm32/step.h"

namespace robosim::exec::stm32 {
namespace {

using Kind = Step::Kind;

/// Returns `kind`. If `flag` is set, returns the next kind in the list of kinds.
constexpr Kind after(Kind kind, bool flag) { return static_cast<Kind>(static_cast<int>(kind) + flag); }

/// Returns one of four consecutive kinds, such as mov_i, mov_r, movs_i and movs_r.
constexpr Kind of_four(Kind first, bool by_register, bool sets) {
  return static_cast<Kind>(static_cast<int>(first) + by_register + 2 * sets);
}

Kind data_kind(const Thumb& t, bool sets) {
  const bool by_register = t.m != Thumb::kZero;
  switch (t.op) {
    case Op::mov:
      return of_four(Kind::mov_i, by_register, sets);
    case Op::add:
      return of_four(Kind::add_i, by_register, sets);
    case Op::sub:
      return of_four(Kind::sub_i, by_register, sets);
    case Op::cmp:
      return after(Kind::cmp_i, by_register);
    case Op::and_:
      return after(Kind::and_, sets);
    case Op::orr:
      return after(Kind::orr, sets);
    case Op::eor:
      return after(Kind::eor, sets);
    case Op::bic:
      return after(Kind::bic, sets);
    case Op::mvn:
      return after(Kind::mvn, sets);
    case Op::tst:
      return Kind::tst;
    case Op::adc:
      return after(Kind::adc, sets);
    case Op::sbc:
      return after(Kind::sbc, sets);
    case Op::rsb:
      return after(Kind::rsb, sets);
    case Op::cmn:
      return Kind::cmn;
    default:
      return after(Kind::data, sets);
  }
}

Kind shifted_kind(const Thumb& t, bool sets) {
  const bool short_of_all = t.value < 32;
  if (t.op == Op::mov_shifted && short_of_all) {
    if (t.shift == kLsl) return after(Kind::lsl, sets);
    if (t.shift == kLsr) return after(Kind::lsr, sets);
    if (t.shift == kAsr) return after(Kind::asr, sets);
  }
  if (!sets && short_of_all && t.shift <= kAsr) {
    const auto by = [&](Kind first) { return static_cast<Kind>(static_cast<int>(first) + t.shift); };
    if (t.op == Op::and_shifted) return by(Kind::and_lsl);
    if (t.op == Op::orr_shifted) return by(Kind::orr_lsl);
    if (t.op == Op::eor_shifted) return by(Kind::eor_lsl);
    if (t.op == Op::bic_shifted) return by(Kind::bic_lsl);
    if (t.op == Op::add_shifted) return by(Kind::add_lsl);
    if (t.op == Op::sub_shifted) return by(Kind::sub_lsl);
    if (t.op == Op::rsb_shifted) return by(Kind::rsb_lsl);
  }
  return after(Kind::shifted, sets);
}

Kind transfer_kind(const Thumb& t) {
  const bool by_register = t.m != Thumb::kZero;
  switch (t.op) {
    case Op::ldr:
      return t.d == Thumb::kPc ? Kind::ldr_pc : after(Kind::ldr_i, by_register);
    case Op::ldrb:
      return after(Kind::ldrb_i, by_register);
    case Op::ldrh:
      return after(Kind::ldrh_i, by_register);
    case Op::ldrsb:
      return Kind::ldrsb;
    case Op::ldrsh:
      return Kind::ldrsh;
    case Op::str:
      return after(Kind::str_i, by_register);
    case Op::strb:
      return after(Kind::strb_i, by_register);
    case Op::strh:
      return after(Kind::strh_i, by_register);
    case Op::ldr_back:
      return t.d == Thumb::kPc ? Kind::ldr_pc_back : Kind::ldr_back;
    case Op::ldrb_back:
      return Kind::ldrb_back;
    case Op::ldrh_back:
      return Kind::ldrh_back;
    case Op::ldrsb_back:
      return Kind::ldrsb_back;
    case Op::ldrsh_back:
      return Kind::ldrsh_back;
    case Op::str_back:
      return Kind::str_back;
    case Op::strb_back:
      return Kind::strb_back;
    case Op::strh_back:
      return Kind::strh_back;
    case Op::ldrd:
      return Kind::ldrd;
    case Op::strd:
      return Kind::strd;
    case Op::ldm:
      return t.value >> Thumb::kPc & 1 ? Kind::ldm_pc : Kind::ldm;
    default:
      return Kind::stm;
  }
}

Kind other_kind(const Thumb& t, bool sets) {
  switch (t.op) {
    case Op::add_high:
    case Op::mov_high:
      return t.d == Thumb::kPc ? Kind::to_pc : Kind::to_sp;
    case Op::shift:
      return after(Kind::shift_r, sets);
    case Op::movt:
      return Kind::movt;
    case Op::mul:
      return after(Kind::mul, sets);
    case Op::mla:
      return Kind::mla;
    case Op::mls:
      return Kind::mls;
    case Op::umull:
    case Op::smull:
    case Op::umlal:
    case Op::smlal:
      return Kind::multiply_long;
    case Op::sdiv:
      return Kind::sdiv;
    case Op::udiv:
      return Kind::udiv;
    case Op::sxtb:
      return Kind::sxtb;
    case Op::sxth:
      return Kind::sxth;
    case Op::uxtb:
      return Kind::uxtb;
    case Op::uxth:
      return Kind::uxth;
    case Op::clz:
      return Kind::clz;
    case Op::rbit:
      return Kind::rbit;
    case Op::rev:
      return Kind::rev;
    case Op::rev16:
      return Kind::rev16;
    case Op::revsh:
      return Kind::revsh;
    case Op::sbfx:
      return Kind::sbfx;
    case Op::ubfx:
      return Kind::ubfx;
    case Op::bfi:
      return Kind::bfi;
    case Op::ssat:
      return Kind::ssat;
    case Op::usat:
      return Kind::usat;
    case Op::b:
    case Op::bl:
    case Op::bcond:
    case Op::cbz:
    case Op::cbnz:
      return Kind::branch;
    case Op::bx:
      return Kind::bx;
    case Op::blx:
      return Kind::blx;
    case Op::tbb:
      return Kind::tbb;
    case Op::tbh:
      return Kind::tbh;
    case Op::it:
      return Kind::it;
    case Op::nop:
      return Kind::nop;
    case Op::wfi:
      return Kind::wfi;
    case Op::wfe:
      return Kind::wfe;
    case Op::sev:
      return Kind::sev;
    case Op::svc:
      return Kind::svc;
    case Op::cps:
      return Kind::cps;
    case Op::msr:
      return Kind::msr;
    case Op::mrs:
      return Kind::mrs;
    default:
      return Kind::emulate;
  }
}

Kind kind_of(const Thumb& t, bool sets) {
  if (t.op == Op::sub && t.d == Thumb::kSp) return Kind::sub_sp;
  const bool stores_back = t.op >= Op::str_back && t.op <= Op::strh_back;
  if (stores_back && t.n == Thumb::kSp) return t.op == Op::str_back ? Kind::push : Kind::emulate;
  if (t.op >= Op::mov && t.op <= Op::cmn) return data_kind(t, sets);
  if (t.op >= Op::mov_shifted && t.op <= Op::cmn_shifted) return shifted_kind(t, sets);
  if (t.op >= Op::ldr && t.op <= Op::stm) return transfer_kind(t);
  return other_kind(t, sets);
}

}  // namespace

Step step_of(const Thumb& t, const Instruction& instruction) {
  Step step;
  step.kind = kind_of(t, t.sets & Thumb::kSetsOutside);
  step.within = kind_of(t, t.sets >> 1);
  step.d = t.d;
  step.n = t.n;
  step.m = t.m;
  step.shift = t.shift;
  step.value = t.value;
  step.ahead = static_cast<std::uint8_t>(8 * instruction.bytes);
  step.cycles = instruction.cycles;
  const auto number = static_cast<unsigned>(t.op);
  if (t.op >= Op::mov && t.op <= Op::cmn) {
    step.shift = t.carry;
    // TEQ and ORN are too rare for separate kinds. For TEQ and ORN, `shift` contains the operation and the
    // carry.
    if (t.op == Op::orn || t.op == Op::teq) step.shift = static_cast<std::uint8_t>(t.carry | number << 2);
  } else if (step.kind == Kind::shifted || step.kind == Kind::shifteds || step.within == Kind::shifteds) {
    const unsigned plain = number - static_cast<unsigned>(Op::mov_shifted) + static_cast<unsigned>(Op::mov);
    step.shift = static_cast<std::uint8_t>(t.shift | plain << 3);
  } else if (step.kind == Kind::branch || step.kind == Kind::multiply_long) {
    if (step.kind == Kind::multiply_long)
      step.value = number;
    else
      step.shift = static_cast<std::uint8_t>(number);
  } else if (step.kind == Kind::it) {
    step.n = instruction.predicates;
    if (step.n == 1) step.kind = step.within = Kind::it_one;
  }
  // A Step that reads the program counter gets the kind `reads_pc`. Its original kind is stored in `shift`.
  if (step.n == Thumb::kPc || step.m == Thumb::kPc) {
    if (step.kind == Kind::tbb || step.kind == Kind::tbh) return step;
    step.shift = static_cast<std::uint8_t>(step.kind);
    if (step.kind != Kind::emulate) step.kind = step.within = Kind::reads_pc;
  }
  return step;
}

Kind direct_kind(const Step& branch) {
  switch (static_cast<Op>(branch.shift)) {
    case Op::bl:
      return Kind::bl;
    case Op::cbz:
      return Kind::cbz;
    case Op::cbnz:
      return Kind::cbnz;
    case Op::bcond:
      return static_cast<Kind>(static_cast<int>(Kind::beq) + branch.d);
    default:
      return Kind::b;
  }
}

}  // namespace robosim::exec::stm32
