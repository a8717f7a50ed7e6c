#include "sim/exec/stm32/clocks.h"

#include "sim/exec/stm32/backup.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr std::uint32_t kHsi = 8'000'000, kHse = 8'000'000;
constexpr SimTime kHseStarts = 2 * kMillisecond, kPllLocks = 200 * kMicrosecond,
                  kLseStarts = 2500 * kMillisecond;  // DS5319, table 23

// Bits of RCC_BDCR.
constexpr std::uint32_t kLseOn = 1u << 0, kLseReady = 1u << 1, kRtcEn = 1u << 15, kDomainReset = 1u << 16;

}  // namespace

void Clocks::reset(Address) {
  static_cast<Registers&>(state_) = {};
  link_.clock.set_hz(hz());
}

// Sets the flag of the cause. Also sets the flag of the NRST pin, since each reset pulls NRST low (RM0008
// 7.1.1).
void Clocks::note(Reset cause) {
  state_.reset_flags |= kPinReset;
  if (cause == Reset::software) state_.reset_flags |= kSoftwareReset;
  if (cause == Reset::independent_watchdog) state_.reset_flags |= kIwdgReset;
  if (cause == Reset::window_watchdog) state_.reset_flags |= kWwdgReset;
}

bool Clocks::pll_ready() const { return state_.control & kPllOn && link_.clock.time() >= state_.pll_ready; }

std::uint32_t Clocks::pll_hz() const {
  const std::uint32_t hse = state_.configuration & kPllXtpre ? kHse / 2 : kHse;
  const std::uint32_t input = state_.configuration & kPllSrcHse ? hse : kHsi / 2;
  const std::uint32_t multiplier = (state_.configuration & kPllMulMask) >> 18;
  return input * (multiplier >= 14 ? 16 : multiplier + 2);
}

std::uint32_t Clocks::rtc_hz() const {
  if (!(state_.backup & kRtcEn)) return 0;
  switch (state_.backup >> 8 & 3) {
    case 1:
      return state_.backup & kLseOn ? 32768 : 0;
    case 2:
      return state_.status & kLsiOn ? 40'000 : 0;
    case 3:
      return state_.control & kHseOn ? kHse / 128 : 0;
    default:
      return 0;
  }
}

std::uint32_t Clocks::hz() const {
  const std::uint32_t source = state_.configuration & kSwMask;
  // HPRE selects a power of two from 1 to 512, except 32, as the divisor.
  const std::uint32_t bits = state_.configuration >> 4 & 15;
  const std::uint32_t ahb = bits < 8 ? 1 : bits < 12 ? 2u << (bits - 8) : 64u << (bits - 12);
  return (source == kSwPll ? pll_hz() : source == 1 ? kHse : kHsi) / ahb;
}

Gate Clocks::gate(Address block) const {
  if (block == kDma1) return {&state_.ahb, nullptr, kDma1En};
  if (block == kCrc) return {&state_.ahb, nullptr, kCrcUnitEn};
  if (block >= kAhb || block == kExti || block == kIwdg || block == kRtc) return {};
  if (behind_apb2(block)) return {&state_.apb2, &state_.apb2_reset, clock_bit(block)};
  return {&state_.apb1, &state_.apb1_reset, clock_bit(block)};
}

Cycle Clocks::same_until(Address) const {
  Cycle until = kNoCycle;
  for (const SimTime ready : {state_.hse_ready, state_.pll_ready, state_.lse_ready})
    if (link_.clock.time() < ready) until = std::min(until, link_.clock.cycle_at(ready));
  return until;
}

std::uint32_t Clocks::read(Address address) {
  switch (address) {
    case kRccCr: {
      std::uint32_t value = state_.control;
      if (value & kHsiOn) value |= kHsiReady;
      if (value & kHseOn && link_.clock.time() >= state_.hse_ready) value |= kHseReady;
      if (pll_ready()) value |= kPllReady;
      return value;
    }
    case kRccCfgr:
      return state_.configuration | (state_.configuration & kSwMask) << 2;
    case kRccCir:
      return state_.interrupts;
    case kRccApb2Rstr:
      return state_.apb2_reset;
    case kRccApb1Rstr:
      return state_.apb1_reset;
    case kRccAhbEnr:
      return state_.ahb;
    case kRccApb2Enr:
      return state_.apb2;
    case kRccApb1Enr:
      return state_.apb1;
    case kRccBdcr:
      return state_.backup |
             (state_.backup & kLseOn && link_.clock.time() >= state_.lse_ready ? kLseReady : 0);
    case kRccCsr:
      return state_.status | (state_.status & kLsiOn) << 1 | state_.reset_flags;
    default:
      return 0;
  }
}

bool Clocks::switch_clock() {
  if ((state_.configuration & kSwMask) == 3) return false;
  link_.clock.set_hz(hz());
  return true;
}

bool Clocks::write(Address address, std::uint32_t value) {
  switch (address) {
    case kRccCr:
      if (value & ~state_.control & kHseOn) state_.hse_ready = link_.clock.time() + kHseStarts;
      if (value & ~state_.control & kPllOn) state_.pll_ready = link_.clock.time() + kPllLocks;
      state_.control = value & ~(kHsiReady | kHseReady | kPllReady);
      return true;
    case kRccCfgr:
      state_.configuration = value & ~kSwsMask;
      return switch_clock();
    case kRccCir:
      state_.interrupts = 0;
      return (value & 0x1F00) == 0;  // clock interrupts are not modelled
    case kRccApb2Rstr:
      state_.apb2_reset = value;
      return true;
    case kRccApb1Rstr:
      state_.apb1_reset = value;
      return true;
    case kRccAhbEnr:
      state_.ahb = value;
      return true;
    case kRccApb2Enr:
      state_.apb2 = value;
      return true;
    case kRccApb1Enr:
      state_.apb1 = value;
      return true;
    case kRccBdcr:
      if (!power_.allows()) return true;
      if (value & ~state_.backup & kLseOn) state_.lse_ready = link_.clock.time() + kLseStarts;
      state_.backup = value & kDomainReset ? kDomainReset : value & ~kLseReady;
      return true;
    case kRccCsr:
      state_.status = value & kLsiOn;  // the LSI is ready at once
      if (value & kRemoveFlags) state_.reset_flags = 0;
      return true;
    default:
      return false;
  }
}

}  // namespace robosim::exec::stm32
