#include "sim/exec/stm32/backup.h"

#include <algorithm>
#include <utility>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Bits of the power control registers (RM0008 5.4).
constexpr std::uint32_t kClearFlags = 3u << 2, kWakeUpPin = 1u << 8;
// Registers and bits of the RTC (18.4).
constexpr Address kCrh = 0x00, kCrl = 0x04, kPrlh = 0x08, kPrll = 0x0C, kDivh = 0x10, kDivl = 0x14,
                  kCnth = 0x18, kCntl = 0x1C, kAlrh = 0x20, kAlrl = 0x24;
constexpr std::uint32_t kSecondFlag = 1u << 0, kAlarm = 1u << 1, kOverflow = 1u << 2, kRsf = 1u << 3,
                        kCnf = 1u << 4, kRtoff = 1u << 5;

std::uint32_t with_high(std::uint32_t word, std::uint32_t half) { return (word & 0xFFFF) | half << 16; }
std::uint32_t with_low(std::uint32_t word, std::uint32_t half) {
  return (word & 0xFFFF0000) | (half & 0xFFFF);
}

}  // namespace

// --- power control

std::uint32_t Power::read(Address address) { return address == kPwr ? state_.control : state_.status; }

bool Power::write(Address address, std::uint32_t value) {
  if (address == kPwr)
    state_.control = value & ~kClearFlags & 0x1FF;
  else
    state_.status = value & kWakeUpPin;
  return true;
}

// --- backup registers (6.4): DR1 to DR10 start at offset 4; RTCCR, CR and CSR follow

std::size_t Backup::place(Address address) { return std::min<std::size_t>((address - kBkp) / 4, 13); }

std::uint32_t Backup::read(Address address) { return state_.data[place(address)]; }

bool Backup::write(Address address, std::uint32_t value) {
  if (power_.allows() && place(address) > 0) state_.data[place(address)] = value & 0xFFFF;
  return place(address) < 11 || value == 0;  // the tamper pin and the calibration are not modelled
}

// --- real-time clock

SimTime Rtc::time_of(std::uint64_t ticks) const {
  const auto periods = static_cast<SimTime>(ticks) * (SimTime{state_.divider} + 1);
  return state_.began + periods / state_.hz * kSecond +
         (periods % state_.hz * kSecond + state_.hz - 1) / state_.hz;
}

std::uint64_t Rtc::ticks() const {
  if (state_.hz == 0) return 0;
  const SimTime passed = now() - state_.began;
  const SimTime periods = passed / kSecond * state_.hz + passed % kSecond * state_.hz / kSecond;
  return static_cast<std::uint64_t>(periods / (SimTime{state_.divider} + 1));
}

void Rtc::restart(std::uint32_t counter) {
  state_.began_with = counter;
  state_.began = now();
  state_.told = 0;
}

void Rtc::set_clock(std::uint32_t hz) {
  if (hz == state_.hz) return;
  update();
  restart(state_.began_with + static_cast<std::uint32_t>(ticks()));
  state_.hz = hz;
}

Cycle Rtc::next_event() const {
  if (state_.hz == 0) return kNoCycle;
  // Finds the next alarm, and the next tick and overflow if their interrupts are enabled.
  const std::uint32_t present = state_.began_with + static_cast<std::uint32_t>(state_.told);
  std::uint64_t next = state_.told + std::uint64_t{state_.alarm - present - 1} + 1;
  if (state_.enabled & kSecondFlag) next = state_.told + 1;
  if (state_.enabled & kOverflow)
    next = std::min<std::uint64_t>(next, state_.told + std::uint64_t{0 - present - 1} + 1);
  constexpr std::uint64_t kTooFar = std::uint64_t{1} << 30;  // seconds
  if (next * (std::uint64_t{state_.divider} + 1) / state_.hz > kTooFar) return kNoCycle;
  return link_.clock.cycle_at(time_of(next));
}

void Rtc::update() {
  const std::uint64_t passed = ticks();
  if (state_.hz == 0 || passed <= state_.told) return;
  const std::uint32_t before = state_.began_with + static_cast<std::uint32_t>(state_.told);
  const std::uint64_t steps = passed - std::exchange(state_.told, passed);
  state_.flags |= kSecondFlag;
  const bool alarm = std::uint64_t{state_.alarm - before - 1} < steps;
  if (alarm) state_.flags |= kAlarm;
  if (std::uint64_t{0 - before - 1} < steps) state_.flags |= kOverflow;
  refresh_line();
  if (alarm) alarmed_();
}

void Rtc::refresh_line() { link_.nvic.set_line(kIrqRtc, state_.flags & state_.enabled); }

void Rtc::reset(Address) {
  state_.enabled = state_.flags = 0;
  state_.configures = false;
  refresh_line();
}

void Rtc::reset_domain() {
  reset(kRtc);
  state_.divider = 0x8000;
  state_.alarm = 0xFFFFFFFF;
  restart(0);
}

std::uint32_t Rtc::read(Address address) {
  update();
  const std::uint32_t counter = state_.began_with + static_cast<std::uint32_t>(state_.told);
  switch (address - kRtc) {
    case kCrh:
      return state_.enabled;
    case kCrl:
      return state_.flags | kRsf | kRtoff | (state_.configures ? kCnf : 0);
    case kDivh:
    case kDivl: {
      if (state_.hz == 0) return state_.divider & 0xFFFF;
      const SimTime within = now() - time_of(state_.told);
      const auto left = static_cast<std::uint32_t>(
          std::max<SimTime>(SimTime{state_.divider} - within * state_.hz / kSecond, 0));
      return address - kRtc == kDivh ? left >> 16 : left & 0xFFFF;
    }
    case kCnth:
      return counter >> 16;
    case kCntl:
      return counter & 0xFFFF;
    default:
      return 0;  // all other registers are write-only
  }
}

bool Rtc::write(Address address, std::uint32_t value) {
  update();
  const std::uint32_t counter = state_.began_with + static_cast<std::uint32_t>(state_.told);
  if (address - kRtc == kCrh) {
    state_.enabled = value & 7;
    refresh_line();
    return true;
  }
  if (address - kRtc == kCrl) {
    state_.configures = value & kCnf;
    state_.flags &= value;
    refresh_line();
    return true;
  }
  if (!state_.configures || !power_.allows()) return true;
  switch (address - kRtc) {
    case kPrlh:
      state_.divider = with_high(state_.divider, value & 15);
      restart(counter);
      break;
    case kPrll:
      state_.divider = with_low(state_.divider, value);
      restart(counter);
      break;
    case kCnth:
      restart(with_high(counter, value));
      break;
    case kCntl:
      restart(with_low(counter, value));
      break;
    case kAlrh:
      state_.alarm = with_high(state_.alarm, value);
      break;
    case kAlrl:
      state_.alarm = with_low(state_.alarm, value);
      break;
    default:
      break;
  }
  return true;
}

}  // namespace robosim::exec::stm32
