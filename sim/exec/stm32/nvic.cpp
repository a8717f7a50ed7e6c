#include "sim/exec/stm32/nvic.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr unsigned kIdle = 256;  ///< current priority outside handlers; every exception has a higher one
constexpr std::uint8_t kPriorityBits = 0xF0;

bool within(Address address, Address first, unsigned bytes) {
  return address >= first && address < first + bytes;
}

}  // namespace

Nvic::Nvic() : enabled_(bit(kSvcall) | bit(kPendSv) | bit(kSysTick)) {}

bool Nvic::owns(Address address) { return address >= kNvicIser && address < 0xE000EF04; }

void Nvic::pend(Exception exception) {
  if (scr_ & kSevOnPend && !(pending_ & bit(exception))) event_ = true;
  pending_ |= bit(exception);
}

void Nvic::set_line(Irq irq, bool high) {
  const Bits line = bit(kFirstIrq + irq);
  if (high && !(lines_ & line)) pend(kFirstIrq + irq);
  lines_ = high ? lines_ | line : lines_ & ~line;
}

unsigned Nvic::current_priority() const {
  unsigned lowest = kIdle;
  for (Exception e = 1; e < kExceptions; ++e)
    if (active_ & bit(e) && priority_[static_cast<std::size_t>(e)] < lowest)
      lowest = priority_[static_cast<std::size_t>(e)];
  return lowest;
}

Exception Nvic::candidate(std::uint32_t basepri) const {
  const Bits waiting = (pending_ | (lines_ & ~active_)) & enabled_;
  if (!waiting) return 0;
  unsigned best = current_priority();
  if (basepri != 0 && basepri < best) best = basepri;
  Exception found = 0;
  for (Exception e = 1; e < kExceptions; ++e) {
    if (!(waiting & bit(e)) || priority_[static_cast<std::size_t>(e)] >= best) continue;
    best = priority_[static_cast<std::size_t>(e)];
    found = e;
  }
  return found;
}

void Nvic::enter(Exception exception) {
  pending_ &= ~bit(exception);
  active_ |= bit(exception);
  event_ = true;
}

void Nvic::leave(Exception exception) {
  active_ &= ~bit(exception);
  event_ = true;
}

Exception Nvic::lowest_active() const {
  Exception found = 0;
  unsigned best = kIdle;
  for (Exception e = 1; e < kExceptions; ++e)
    if (active_ & bit(e) && priority_[static_cast<std::size_t>(e)] < best) {
      best = priority_[static_cast<std::size_t>(e)];
      found = e;
    }
  return found;
}

std::uint32_t Nvic::irq_word(Bits bits, Address offset) const {
  return static_cast<std::uint32_t>(bits >> kFirstIrq >> (8 * offset));
}

std::uint32_t Nvic::control_state() const {
  std::uint32_t value = static_cast<std::uint32_t>(lowest_active());
  value |= static_cast<std::uint32_t>(candidate(0)) << 12;
  if (pending_ & bit(kSysTick)) value |= kPendStSet;
  if (pending_ & bit(kPendSv)) value |= kPendSvSet;
  if ((pending_ | lines_) >> kFirstIrq) value |= 1u << 22;
  return value;
}

bool Nvic::read(Address address, std::uint32_t& value) const {
  const auto four = [&](Address first, int from) {
    value = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::size_t number = static_cast<std::size_t>(from) + (address - first) + i;
      if (number < priority_.size()) value |= static_cast<std::uint32_t>(priority_[number]) << (8 * i);
    }
  };
  if (within(address, kNvicIser, 8)) return value = irq_word(enabled_, address - kNvicIser), true;
  if (within(address, kNvicIcer, 8)) return value = irq_word(enabled_, address - kNvicIcer), true;
  if (within(address, kNvicIspr, 8)) return value = irq_word(pending_, address - kNvicIspr), true;
  if (within(address, kNvicIcpr, 8)) return value = irq_word(pending_, address - kNvicIcpr), true;
  if (within(address, kNvicIabr, 8)) return value = irq_word(active_, address - kNvicIabr), true;
  if (within(address, kNvicIpr, 60)) return four(kNvicIpr, kFirstIrq), true;
  if (within(address, kScbShpr1, 12)) return four(kScbShpr1, 4), true;
  switch (address) {
    case kScbCpuid:
      value = 0x411FC231;  // r1p1 (PM0056 4.4.2)
      return true;
    case kScbIcsr:
      value = control_state();
      return true;
    case kScbVtor:
      value = vtor_;
      return true;
    case kScbAircr:
      value = 0xFA050000;
      return true;
    case kScbScr:
      value = scr_;
      return true;
    case kScbCcr:
      value = ccr_;
      return true;
    case kScbShcsr:
      value = shcsr_;
      return true;
    case kScbCfsr:
    case kScbHfsr:
    case kScbMmfar:
    case kScbBfar:
      value = 0;  // no fault address, since a fault ends the run
      return true;
    default:
      return false;
  }
}

bool Nvic::write(Address address, std::uint32_t value) {
  const auto bits = [&](Address first) { return (Bits{value} << (8 * (address - first))) << kFirstIrq; };
  const auto four = [&](Address first, int from) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::size_t number = static_cast<std::size_t>(from) + (address - first) + i;
      if (number < priority_.size())
        priority_[number] = static_cast<std::uint8_t>(value >> (8 * i)) & kPriorityBits;
    }
  };
  if (within(address, kNvicIser, 8)) return enabled_ |= bits(kNvicIser), true;
  if (within(address, kNvicIcer, 8)) return enabled_ &= ~bits(kNvicIcer), true;
  if (within(address, kNvicIspr, 8)) return pending_ |= bits(kNvicIspr), true;
  if (within(address, kNvicIcpr, 8)) return pending_ &= ~bits(kNvicIcpr), true;
  if (within(address, kNvicIpr, 60)) return four(kNvicIpr, kFirstIrq), true;
  if (within(address, kScbShpr1, 12)) return four(kScbShpr1, 4), true;
  return write_scb(address, value);
}

bool Nvic::write_scb(Address address, std::uint32_t value) {
  switch (address) {
    case kScbIcsr:
      if (value & kPendStSet) pend(kSysTick);
      if (value & kPendStClr) unpend(kSysTick);
      if (value & kPendSvSet) pend(kPendSv);
      if (value & kPendSvClr) unpend(kPendSv);
      return true;
    case kScbVtor:
      vtor_ = value & 0x3FFFFF80;
      return true;
    case kScbAircr:
      if (value >> 16 != 0x05FA) return true;
      reset_requested_ = value & kSysResetReq;
      // Only the priority groupings 0 to 3 are modelled, in which all four bits preempt.
      return (value & 0x3) == 0 && (value >> 8 & 7) <= 3;
    case kScbScr:
      if (value & kSleepDeep) return false;
      scr_ = value;
      return true;
    case kScbCcr:
      if (value & kUnalignTrap) return false;
      ccr_ = value;
      return true;
    case kScbShcsr:
      shcsr_ = value;
      return true;
    case kNvicStir:
      if ((value & 0x1FF) < kIrqCount) pend(kFirstIrq + static_cast<Exception>(value & 0x1FF));
      return true;
    case kScbCfsr:
    case kScbHfsr:
      return true;
    default:
      return false;
  }
}

}  // namespace robosim::exec::stm32
