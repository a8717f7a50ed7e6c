#include "sim/exec/stm32/clocks.h"

#include "sim/exec/stm32/backup.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kHsi = 8'000'000, kHse = 8'000'000;
constexpr SimTime kHseStarts = 2 * kMillisecond, kPllLocks = 200 * kMicrosecond,
                  kLseStarts = 2500 * kMillisecond;  // DS5319, table 23

// RCC_BDCR
constexpr std::uint32_t kLseOn = 1u << 0, kLseReady = 1u << 1, kRtcEn = 1u << 15, kDomainReset = 1u << 16;

}  // namespace

void Clocks::reset(Address) {
  static_cast<ClockRegisters&>(*this) = {};
  link_.clock.set_hz(hz());
}

// Each reset pulls the pin NRST low, too (RM0008 7.1.1).
void Clocks::note(Reset cause) {
  reset_flags_ |= kPinReset;
  if (cause == Reset::software) reset_flags_ |= kSoftwareReset;
  if (cause == Reset::independent_watchdog) reset_flags_ |= kIwdgReset;
  if (cause == Reset::window_watchdog) reset_flags_ |= kWwdgReset;
}

bool Clocks::pll_ready() const { return control_ & kPllOn && link_.clock.time() >= pll_ready_; }

std::uint32_t Clocks::pll_hz() const {
  const std::uint32_t hse = configuration_ & kPllXtpre ? kHse / 2 : kHse;
  const std::uint32_t input = configuration_ & kPllSrcHse ? hse : kHsi / 2;
  const std::uint32_t multiplier = (configuration_ & kPllMulMask) >> 18;
  return input * (multiplier >= 14 ? 16 : multiplier + 2);
}

// HSE's 8 MHz are divided by 128.
std::uint32_t Clocks::rtc_hz() const {
  if (!(backup_ & kRtcEn)) return 0;
  switch (backup_ >> 8 & 3) {
    case 1:
      return backup_ & kLseOn ? 32768 : 0;
    case 2:
      return status_ & kLsiOn ? 40'000 : 0;
    case 3:
      return control_ & kHseOn ? kHse / 128 : 0;
    default:
      return 0;
  }
}

std::uint32_t Clocks::hz() const {
  const std::uint32_t source = configuration_ & kSwMask;
  // HPRE: 2 to 512, but not 32
  const std::uint32_t bits = configuration_ >> 4 & 15;
  const std::uint32_t ahb = bits < 8 ? 1 : bits < 12 ? 2u << (bits - 8) : 64u << (bits - 12);
  return (source == kSwPll ? pll_hz() : source == 1 ? kHse : kHsi) / ahb;
}

Gate Clocks::gate(Address block) const {
  if (block == kDma1) return {&ahb_, nullptr, kDma1En};
  if (block == kCrc) return {&ahb_, nullptr, kCrcUnitEn};
  if (block >= kAhb || block == kExti || block == kIwdg || block == kRtc) return {};
  if (behind_apb2(block)) return {&apb2_, &apb2_reset_, clock_bit(block)};
  return {&apb1_, &apb1_reset_, clock_bit(block)};
}

Cycle Clocks::same_until(Address) const {
  Cycle until = kNoCycle;
  for (const SimTime ready : {hse_ready_, pll_ready_, lse_ready_})
    if (link_.clock.time() < ready) until = std::min(until, link_.clock.cycle_at(ready));
  return until;
}

std::uint32_t Clocks::read(Address address) {
  switch (address) {
    case kRccCr: {
      std::uint32_t value = control_;
      if (value & kHsiOn) value |= kHsiReady;
      if (value & kHseOn && link_.clock.time() >= hse_ready_) value |= kHseReady;
      if (pll_ready()) value |= kPllReady;
      return value;
    }
    case kRccCfgr:
      return configuration_ | (configuration_ & kSwMask) << 2;
    case kRccCir:
      return interrupts_;
    case kRccApb2Rstr:
      return apb2_reset_;
    case kRccApb1Rstr:
      return apb1_reset_;
    case kRccAhbEnr:
      return ahb_;
    case kRccApb2Enr:
      return apb2_;
    case kRccApb1Enr:
      return apb1_;
    case kRccBdcr:
      return backup_ | (backup_ & kLseOn && link_.clock.time() >= lse_ready_ ? kLseReady : 0);
    case kRccCsr:
      return status_ | (status_ & kLsiOn) << 1 | reset_flags_;
    default:
      return 0;
  }
}

bool Clocks::switch_clock() {
  if ((configuration_ & kSwMask) == 3) return false;
  link_.clock.set_hz(hz());
  return true;
}

bool Clocks::write(Address address, std::uint32_t value) {
  switch (address) {
    case kRccCr:
      if (value & ~control_ & kHseOn) hse_ready_ = link_.clock.time() + kHseStarts;
      if (value & ~control_ & kPllOn) pll_ready_ = link_.clock.time() + kPllLocks;
      control_ = value & ~(kHsiReady | kHseReady | kPllReady);
      return true;
    case kRccCfgr:
      configuration_ = value & ~kSwsMask;
      return switch_clock();
    case kRccCir:
      interrupts_ = 0;
      return (value & 0x1F00) == 0;  // no interrupt of it is modelled
    case kRccApb2Rstr:
      apb2_reset_ = value;
      return true;
    case kRccApb1Rstr:
      apb1_reset_ = value;
      return true;
    case kRccAhbEnr:
      ahb_ = value;
      return true;
    case kRccApb2Enr:
      apb2_ = value;
      return true;
    case kRccApb1Enr:
      apb1_ = value;
      return true;
    case kRccBdcr:
      if (!power_.allows()) return true;
      if (value & ~backup_ & kLseOn) lse_ready_ = link_.clock.time() + kLseStarts;
      backup_ = value & kDomainReset ? kDomainReset : value & ~kLseReady;
      return true;
    case kRccCsr:
      status_ = value & kLsiOn;  // there at once
      if (value & kRemoveFlags) reset_flags_ = 0;
      return true;
    default:
      return false;
  }
}

}  // namespace robosim::exec::stm32
