#include "sim/exec/stm32/backup.h"

#include <algorithm>
#include <utility>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 5.4
constexpr std::uint32_t kClearFlags = 3u << 2, kWakeUpPin = 1u << 8;
// 18.4
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

std::uint32_t Power::read(Address address) { return address == kPwr ? control_ : status_; }

bool Power::write(Address address, std::uint32_t value) {
  if (address == kPwr)
    control_ = value & ~kClearFlags & 0x1FF;
  else
    status_ = value & kWakeUpPin;
  return true;
}

// --- backup registers (6.4): DR1 to DR10 from 4 on, then RTCCR, CR, CSR

std::size_t Backup::place(Address address) { return std::min<std::size_t>((address - kBkp) / 4, 13); }

std::uint32_t Backup::read(Address address) { return data_[place(address)]; }

bool Backup::write(Address address, std::uint32_t value) {
  if (power_.allows() && place(address) > 0) data_[place(address)] = value & 0xFFFF;
  return place(address) < 11 || value == 0;  // no tamper pin, no calibration
}

// --- the clock

SimTime Rtc::time_of(std::uint64_t ticks) const {
  const auto periods = static_cast<SimTime>(ticks) * (SimTime{divider_} + 1);
  return began_ + periods / hz_ * kSecond + (periods % hz_ * kSecond + hz_ - 1) / hz_;
}

std::uint64_t Rtc::ticks() const {
  if (hz_ == 0) return 0;
  const SimTime passed = now() - began_;
  const SimTime periods = passed / kSecond * hz_ + passed % kSecond * hz_ / kSecond;
  return static_cast<std::uint64_t>(periods / (SimTime{divider_} + 1));
}

void Rtc::restart(std::uint32_t counter) {
  began_with_ = counter;
  began_ = now();
  told_ = 0;
}

void Rtc::set_clock(std::uint32_t hz) {
  if (hz == hz_) return;
  update();
  restart(began_with_ + static_cast<std::uint32_t>(ticks()));
  hz_ = hz;
}

Cycle Rtc::next_event() const {
  if (hz_ == 0) return kNoCycle;
  // Of the alarm, and of each tick if that interrupts.
  const std::uint32_t present = began_with_ + static_cast<std::uint32_t>(told_);
  std::uint64_t next = told_ + std::uint64_t{alarm_ - present - 1} + 1;
  if (enabled_ & kSecondFlag) next = told_ + 1;
  if (enabled_ & kOverflow) next = std::min<std::uint64_t>(next, told_ + std::uint64_t{0 - present - 1} + 1);
  constexpr std::uint64_t kTooFar = std::uint64_t{1} << 30;  // seconds
  if (next * (std::uint64_t{divider_} + 1) / hz_ > kTooFar) return kNoCycle;
  return link_.clock.cycle_at(time_of(next));
}

void Rtc::update() {
  const std::uint64_t passed = ticks();
  if (hz_ == 0 || passed <= told_) return;
  const std::uint32_t before = began_with_ + static_cast<std::uint32_t>(told_);
  const std::uint64_t steps = passed - std::exchange(told_, passed);
  flags_ |= kSecondFlag;
  const bool alarm = std::uint64_t{alarm_ - before - 1} < steps;
  if (alarm) flags_ |= kAlarm;
  if (std::uint64_t{0 - before - 1} < steps) flags_ |= kOverflow;
  refresh_line();
  if (alarm) alarmed_();
}

void Rtc::refresh_line() { link_.nvic.set_line(kIrqRtc, flags_ & enabled_); }

void Rtc::reset(Address) {
  enabled_ = flags_ = 0;
  configures_ = false;
  refresh_line();
}

void Rtc::reset_domain() {
  reset(kRtc);
  divider_ = 0x8000;
  alarm_ = 0xFFFFFFFF;
  restart(0);
}

std::uint32_t Rtc::read(Address address) {
  update();
  const std::uint32_t counter = began_with_ + static_cast<std::uint32_t>(told_);
  switch (address - kRtc) {
    case kCrh:
      return enabled_;
    case kCrl:
      return flags_ | kRsf | kRtoff | (configures_ ? kCnf : 0);
    case kDivh:
    case kDivl: {
      if (hz_ == 0) return divider_ & 0xFFFF;
      const SimTime within = now() - time_of(told_);
      const auto left =
          static_cast<std::uint32_t>(std::max<SimTime>(SimTime{divider_} - within * hz_ / kSecond, 0));
      return address - kRtc == kDivh ? left >> 16 : left & 0xFFFF;
    }
    case kCnth:
      return counter >> 16;
    case kCntl:
      return counter & 0xFFFF;
    default:
      return 0;  // the others can only be written
  }
}

bool Rtc::write(Address address, std::uint32_t value) {
  update();
  const std::uint32_t counter = began_with_ + static_cast<std::uint32_t>(told_);
  if (address - kRtc == kCrh) {
    enabled_ = value & 7;
    refresh_line();
    return true;
  }
  if (address - kRtc == kCrl) {
    configures_ = value & kCnf;
    flags_ &= value;
    refresh_line();
    return true;
  }
  if (!configures_ || !power_.allows()) return true;
  switch (address - kRtc) {
    case kPrlh:
      divider_ = with_high(divider_, value & 15);
      restart(counter);
      break;
    case kPrll:
      divider_ = with_low(divider_, value);
      restart(counter);
      break;
    case kCnth:
      restart(with_high(counter, value));
      break;
    case kCntl:
      restart(with_low(counter, value));
      break;
    case kAlrh:
      alarm_ = with_high(alarm_, value);
      break;
    case kAlrl:
      alarm_ = with_low(alarm_, value);
      break;
    default:
      break;
  }
  return true;
}

}  // namespace robosim::exec::stm32
