// What instructions do (ARMv7-M ARM, A7.7). One that is not done here has changed nothing, and goes to
// libunicorn.
#include <bit>
#include <cstring>

#include "sim/exec/stm32/cpu_memory.h"
#include "sim/exec/stm32/thumb_values.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

[[gnu::always_inline]] inline bool Cpu::passes(unsigned condition) const {
  const bool n = flag_n_ >> 31, z = flag_z_ == 0, c = flag_c_, v = flag_v_;
  bool holds = true;
  switch (condition >> 1) {
    case 0:
      holds = z;
      break;
    case 1:
      holds = c;
      break;
    case 2:
      holds = n;
      break;
    case 3:
      holds = v;
      break;
    case 4:
      holds = c && !z;
      break;
    case 5:
      holds = n == v;
      break;
    case 6:
      holds = n == v && !z;
      break;
    default:
      return true;
  }
  return holds != (condition & 1);
}

[[gnu::always_inline]] inline bool Cpu::execute(const Thumb& t, unsigned within_it) {
  const bool sets = t.sets >> within_it & 1;
  const auto set_nz = [&](std::uint32_t result) { flag_n_ = flag_z_ = result; };
  const auto logical = [&](std::uint32_t result, std::uint32_t carry) {
    if (sets) {
      set_nz(result);
      flag_c_ = carry;
    }
    return result;
  };
  const auto sum = [&](std::uint32_t a, std::uint32_t b, std::uint32_t carry) {
    const std::uint64_t wide = std::uint64_t{a} + b + carry;
    const auto result = static_cast<std::uint32_t>(wide);
    if (sets) {
      set_nz(result);
      flag_c_ = static_cast<std::uint32_t>(wide >> 32);
      flag_v_ = ((a ^ result) & (b ^ result)) >> 31;
    }
    return result;
  };
  const std::uint32_t n = r_[t.n], m = r_[t.m];
  std::uint32_t b = m + t.value, shifted_out = flag_c_;
  Op op = t.op;
  const bool shifts = op >= Op::mov_shifted && op <= Op::cmn_shifted;
  if (shifts) {
    b = shifted(t.shift, m, t.value, shifted_out);
    op = static_cast<Op>(static_cast<unsigned>(op) - static_cast<unsigned>(Op::mov_shifted) +
                         static_cast<unsigned>(Op::mov));
  }
  const auto carry = [&] { return t.carry == Thumb::kCarryStays ? shifted_out : t.carry; };
  std::uint32_t& d = r_[t.d];
  switch (op) {
    case Op::mov:
      d = logical(b, carry());
      return true;
    case Op::mvn:
      d = logical(~b, carry());
      return true;
    case Op::and_:
      d = logical(n & b, carry());
      return true;
    case Op::orr:
      d = logical(n | b, carry());
      return true;
    case Op::orn:
      d = logical(n | ~b, carry());
      return true;
    case Op::eor:
      d = logical(n ^ b, carry());
      return true;
    case Op::bic:
      d = logical(n & ~b, carry());
      return true;
    case Op::add:
      d = sum(n, b, 0);
      return true;
    case Op::adc:
      d = sum(n, b, flag_c_);
      return true;
    case Op::sub:
      d = sum(n, ~b, 1);
      return true;
    case Op::sbc:
      d = sum(n, ~b, flag_c_);
      return true;
    case Op::rsb:
      d = sum(~n, b, 1);
      return true;
    case Op::tst:
      logical(n & b, carry());
      return true;
    case Op::teq:
      logical(n ^ b, carry());
      return true;
    case Op::cmp:
      sum(n, ~b, 1);
      return true;
    case Op::cmn:
      sum(n, b, 0);
      return true;
    case Op::add_high:
    case Op::mov_high: {
      const std::uint32_t result = t.op == Op::add_high ? n + m : m;
      if (t.d == kPc)
        after_ = result & ~1u;
      else
        d = result & ~3u;
      return true;
    }
    case Op::shift: {
      std::uint32_t out = flag_c_;
      const unsigned amount = m & 0xFF;
      const std::uint32_t result = amount == 0 ? n : shifted(t.shift, n, amount, out);
      d = logical(result, out);
      return true;
    }
    case Op::movt:
      d = (d & 0xFFFF) | t.value << 16;
      return true;
    case Op::mul:
      d = n * m;
      if (sets) set_nz(d);
      return true;
    case Op::mla:
      d = n * m + r_[t.shift];
      return true;
    case Op::mls:
      d = r_[t.shift] - n * m;
      return true;
    case Op::umull:
    case Op::smull:
    case Op::umlal:
    case Op::smlal: {
      const bool is_signed = t.op == Op::smull || t.op == Op::smlal;
      std::uint64_t product = is_signed
                                  ? static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(n)} *
                                                               static_cast<std::int32_t>(m))
                                  : std::uint64_t{n} * m;
      if (t.op >= Op::umlal) product += std::uint64_t{r_[t.shift]} << 32 | d;
      d = static_cast<std::uint32_t>(product);
      r_[t.shift] = static_cast<std::uint32_t>(product >> 32);
      return true;
    }
    case Op::sdiv:
    case Op::udiv:
      d = quotient(n, m, t.op == Op::sdiv);
      return true;
    case Op::sxtb:
      d = sign_extended(std::rotr(m, static_cast<int>(t.value)), 8);
      return true;
    case Op::sxth:
      d = sign_extended(std::rotr(m, static_cast<int>(t.value)), 16);
      return true;
    case Op::uxtb:
      d = std::rotr(m, static_cast<int>(t.value)) & 0xFF;
      return true;
    case Op::uxth:
      d = std::rotr(m, static_cast<int>(t.value)) & 0xFFFF;
      return true;
    case Op::clz:
      d = static_cast<std::uint32_t>(std::countl_zero(m));
      return true;
    case Op::rbit:
      d = reversed(m);
      return true;
    case Op::rev:
      d = __builtin_bswap32(m);
      return true;
    case Op::rev16:
      d = std::rotr(__builtin_bswap32(m), 16);
      return true;
    case Op::revsh:
      d = sign_extended(__builtin_bswap32(m) >> 16, 16);
      return true;
    case Op::sbfx:
      d = sign_extended(n >> t.shift, t.value);
      return true;
    case Op::ubfx:
      d = n >> t.shift & (0xFFFFFFFFu >> (32 - t.value));
      return true;
    case Op::bfi: {
      const std::uint32_t mask = 0xFFFFFFFFu >> (32 - t.value) << t.shift;
      d = (d & ~mask) | (n << t.shift & mask);
      return true;
    }
    case Op::ldr:
      if (t.d == kPc) {
        std::uint32_t target = 0;
        return memory(n + (m << t.shift) + t.value, 4) && load<4>(n + (m << t.shift) + t.value, target) &&
               branch_to(target);
      }
      return load<4>(n + (m << t.shift) + t.value, d);
    case Op::ldrb:
      return load<1>(n + (m << t.shift) + t.value, d);
    case Op::ldrh:
      return load<2>(n + (m << t.shift) + t.value, d);
    case Op::ldrsb:
    case Op::ldrsh:
      return load_as(t.op, n + (m << t.shift) + t.value, d);
    case Op::str:
      return store<4>(n + (m << t.shift) + t.value, d);
    case Op::strb:
      return store<1>(n + (m << t.shift) + t.value, d);
    case Op::strh:
      return store<2>(n + (m << t.shift) + t.value, d);
    case Op::ldr_back:
    case Op::ldrb_back:
    case Op::ldrh_back:
    case Op::ldrsb_back:
    case Op::ldrsh_back:
    case Op::str_back:
    case Op::strb_back:
    case Op::strh_back:
      return transfer_back(t);
    case Op::ldrd:
    case Op::strd:
      return transfer_two(t);
    case Op::ldm:
    case Op::stm:
      return transfer_many(t);
    case Op::bl:
      r_[kLr] = next_ | 1;
      [[fallthrough]];
    case Op::b:
      after_ = t.value;
      return true;
    case Op::bcond:
      if (passes(t.d)) after_ = t.value;
      return true;
    case Op::bx:
      return branch_to(m);
    case Op::blx:
      if (!branch_to(m)) return false;
      r_[kLr] = next_ | 1;
      return true;
    case Op::cbz:
      if (n == 0) after_ = t.value;
      return true;
    case Op::cbnz:
      if (n != 0) after_ = t.value;
      return true;
    case Op::tbb:
    case Op::tbh: {
      std::uint32_t entries = 0;
      const bool halves = t.op == Op::tbh;
      const Address at = n + (halves ? 2 * m : m);
      if (!memory(at, halves ? 2 : 1)) return false;
      std::memcpy(&entries, memory(at, halves ? 2 : 1), halves ? 2 : 1);
      after_ = next_ + 2 * entries;
      return true;
    }
    case Op::it:
      it_ = t.value;
      return true;
    case Op::nop:
      return true;
    case Op::wfi:
    case Op::wfe:
      waits_for_event_ = t.op == Op::wfe;
      falls_asleep_ = ends_ = !waits_for_event_ || !nvic_.take_event();
      return true;
    case Op::sev:
      nvic_.set_event();
      return true;
    case Op::svc:
      nvic_.pend(kSvcall);
      ends_ = true;
      return true;
    case Op::cps:
      change_masks(t.value);
      return true;
    case Op::msr:
      return write_special(t.value, n);
    case Op::mrs:
      return read_special(t.value, d);
    default:
      return false;
  }
}

bool Cpu::execute_rarely(const Thumb& thumb, unsigned within_it) { return execute(thumb, within_it); }

bool Cpu::step() {
  const Cached* const entry = cached(after_);
  if (!entry) {
    if (look_after_) after_special();
    jumped_nowhere(after_);
    return false;
  }
  const std::uint32_t it = it_;
  if (it != 0) {
    it_ = it & 7 ? (it & 0xE0) | (it << 1 & 0x1F) : 0;
    if (!passes(it >> 4)) {
      // It takes no time, but the pipeline is filled anew behind it.
      after_ += entry->instruction.bytes;
      return true;
    }
  }
  if (!before(after_, *entry)) {
    it_ = it;
    return false;
  }
  after_ = next_;
  r_[kPc] = pc_ + 4;
  const bool refereed = referee_ && entry->thumb.op < Op::it;
  if (refereed || !execute_rarely(entry->thumb, it != 0)) emulate();
  return true;
}

void Cpu::run_to(Cycle cycle) {
  if (asleep_ || fault_) return;
  stop_ = cycle;
  ends_ = falls_asleep_ = false;
  after_ = next_;
  const Cached* const cache = cache_.data();
  while (!ends_) {
    const std::uint32_t pc = after_, offset = pc - kFlash;
    const Cached* const entry = offset < kFlashBytes ? cache + offset / 2 : nullptr;
    if (!entry || !entry->plain || it_ != 0 || predicated_ != 0 || look_after_ || halting_) {
      if (!step()) break;
      continue;
    }
    // What before() does, as far as it can matter here.
    if (pc != next_) {
      clock_.now += kRefill_cycles;
      note_jump();
    }
    next_ = pc;
    if (clock_.now >= stop_) break;
    pc_ = pc;
    next_ = after_ = pc + entry->instruction.bytes;
    clock_.now += entry->instruction.cycles;
    r_[kPc] = pc + 4;
    if (!execute(entry->thumb, 0)) emulate();
  }
  if (look_after_) after_special();
  if (fault_) return;
  if (returning_) return leave();
  asleep_ = falls_asleep_;
}

}  // namespace robosim::exec::stm32
