#include "sim/exec/stm32/watchdogs.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 19.4, 20.6
constexpr Address kIwdgKr = kIwdg + 0x00, kIwdgPr = kIwdg + 0x04, kIwdgRlr = kIwdg + 0x08;
constexpr std::uint32_t kUnlock = 0x5555, kReload = 0xAAAA, kStart = 0xCCCC;
constexpr SimTime kLsiPeriod = kSecond / 40'000;
constexpr Address kWwdgCr = kWwdg + 0x00, kWwdgCfr = kWwdg + 0x04;
constexpr std::uint32_t kActivate = 1u << 7, kEarlyWakeup = 1u << 9, kCounter = 0x7F, kLast = 0x40;

}  // namespace

SimTime IndependentWatchdog::step() const { return kLsiPeriod * (4 << std::min(prescaler_, 6u)); }

std::uint32_t IndependentWatchdog::read(Address address) {
  return address == kIwdgPr ? prescaler_ : address == kIwdgRlr ? reload_ : 0;
}

bool IndependentWatchdog::write(Address address, std::uint32_t value) {
  const SimTime now = link_.clock.time_of(link_.clock.now);
  const auto start = [&] { ends_ = now + step() * (SimTime{reload_} + 1); };
  switch (address) {
    case kIwdgKr:
      unlocked_ = value == kUnlock;
      if (value == kStart && !std::exchange(runs_, true)) start();
      if (value == kReload) start();
      return true;
    case kIwdgPr: {
      if (!unlocked_) return true;
      const SimTime left = (ends_ - now + step() - 1) / step();
      prescaler_ = value & 7;
      ends_ = now + left * step();
      return true;
    }
    case kIwdgRlr:
      if (unlocked_) reload_ = value & 0xFFF;
      return true;
    default:
      return true;
  }
}

void IndependentWatchdog::reset(Address) {
  runs_ = unlocked_ = false;
  prescaler_ = 0;
  reload_ = 0xFFF;
}

void IndependentWatchdog::update() {
  if (link_.clock.now >= next_event()) link_.reset_cause = Reset::independent_watchdog;
}

Cycle WindowWatchdog::step() const {
  return Cycle{4096} * clocks_.apb1_divider() << (configuration_ >> 7 & 3);
}

std::uint32_t WindowWatchdog::count() const {
  const Cycle steps = (link_.clock.now - written_at_) / step();
  return static_cast<std::uint32_t>((written_ + 0x80 - steps % 0x80) & kCounter);
}

Cycle WindowWatchdog::reaches(std::uint32_t value) const {
  return written_ < value ? kNoCycle : written_at_ + (written_ - value) * step();
}

Cycle WindowWatchdog::next_event() const {
  if (!on_) return kNoCycle;
  const Cycle end = reaches(kLast - 1);
  return told_ ? end : std::min(end, reaches(kLast));
}

void WindowWatchdog::update() {
  if (!on_) return;
  if (!told_ && link_.clock.now >= reaches(kLast)) {
    told_ = early_ = true;
    link_.nvic.set_line(kIrqWwdg, configuration_ & kEarlyWakeup);
  }
  if (link_.clock.now >= reaches(kLast - 1)) link_.reset_cause = Reset::window_watchdog;
}

std::uint32_t WindowWatchdog::read(Address address) {
  update();
  if (address == kWwdgCr) return count() | (on_ ? kActivate : 0);
  return address == kWwdgCfr ? configuration_ : early_;
}

bool WindowWatchdog::write(Address address, std::uint32_t value) {
  update();
  switch (address) {
    case kWwdgCr: {
      const bool too_early = on_ && count() > (configuration_ & kCounter);
      on_ = on_ || value & kActivate;
      written_ = value & kCounter;
      written_at_ = link_.clock.now;
      told_ = false;
      if (on_ && (too_early || written_ < kLast)) link_.reset_cause = Reset::window_watchdog;
      return true;
    }
    case kWwdgCfr:
      // EWI can only be set by software (20.6.2).
      written_ = count();
      written_at_ = link_.clock.now;
      configuration_ = (value & 0x3FF) | (configuration_ & kEarlyWakeup);
      return true;
    default:
      early_ = early_ && value & 1;
      link_.nvic.set_line(kIrqWwdg, early_ && configuration_ & kEarlyWakeup);
      return true;
  }
}

void WindowWatchdog::reset(Address) {
  configuration_ = written_ = 0x7F;
  on_ = early_ = told_ = false;
  link_.nvic.set_line(kIrqWwdg, false);
}

}  // namespace robosim::exec::stm32
