#include "sim/exec/stm32/watchdogs.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Registers and bits (RM0008 19.4, 20.6).
constexpr Address kIwdgKr = kIwdg + 0x00, kIwdgPr = kIwdg + 0x04, kIwdgRlr = kIwdg + 0x08;
constexpr std::uint32_t kUnlock = 0x5555, kReload = 0xAAAA, kStart = 0xCCCC;
constexpr SimTime kLsiPeriod = kSecond / 40'000;
constexpr Address kWwdgCr = kWwdg + 0x00, kWwdgCfr = kWwdg + 0x04;
constexpr std::uint32_t kActivate = 1u << 7, kEarlyWakeup = 1u << 9, kCounter = 0x7F, kLast = 0x40;

}  // namespace

SimTime IndependentWatchdog::step() const { return kLsiPeriod * (4 << std::min(state_.prescaler, 6u)); }

std::uint32_t IndependentWatchdog::read(Address address) {
  return address == kIwdgPr ? state_.prescaler : address == kIwdgRlr ? state_.reload : 0;
}

bool IndependentWatchdog::write(Address address, std::uint32_t value) {
  const SimTime now = link_.clock.time_of(link_.clock.now);
  const auto start = [&] { state_.ends = now + step() * (SimTime{state_.reload} + 1); };
  switch (address) {
    case kIwdgKr:
      state_.unlocked = value == kUnlock;
      if (value == kStart && !std::exchange(state_.runs, true)) start();
      if (value == kReload) start();
      return true;
    case kIwdgPr: {
      if (!state_.unlocked) return true;
      const SimTime left = (state_.ends - now + step() - 1) / step();
      state_.prescaler = value & 7;
      state_.ends = now + left * step();
      return true;
    }
    case kIwdgRlr:
      if (state_.unlocked) state_.reload = value & 0xFFF;
      return true;
    default:
      return true;
  }
}

void IndependentWatchdog::reset(Address) {
  state_.runs = state_.unlocked = false;
  state_.prescaler = 0;
  state_.reload = 0xFFF;
}

void IndependentWatchdog::update() {
  if (link_.clock.now >= next_event()) link_.reset_cause = Reset::independent_watchdog;
}

Cycle WindowWatchdog::step() const {
  return Cycle{4096} * clocks_.apb1_divider() << (state_.configuration >> 7 & 3);
}

std::uint32_t WindowWatchdog::count() const {
  const Cycle steps = (link_.clock.now - state_.written_at) / step();
  return static_cast<std::uint32_t>((state_.written + 0x80 - steps % 0x80) & kCounter);
}

Cycle WindowWatchdog::reaches(std::uint32_t value) const {
  return state_.written < value ? kNoCycle : state_.written_at + (state_.written - value) * step();
}

Cycle WindowWatchdog::next_event() const {
  if (!state_.on) return kNoCycle;
  const Cycle end = reaches(kLast - 1);
  return state_.told ? end : std::min(end, reaches(kLast));
}

void WindowWatchdog::update() {
  if (!state_.on) return;
  if (!state_.told && link_.clock.now >= reaches(kLast)) {
    state_.told = state_.early = true;
    link_.nvic.set_line(kIrqWwdg, state_.configuration & kEarlyWakeup);
  }
  if (link_.clock.now >= reaches(kLast - 1)) link_.reset_cause = Reset::window_watchdog;
}

std::uint32_t WindowWatchdog::read(Address address) {
  update();
  if (address == kWwdgCr) return count() | (state_.on ? kActivate : 0);
  return address == kWwdgCfr ? state_.configuration : state_.early;
}

bool WindowWatchdog::write(Address address, std::uint32_t value) {
  update();
  switch (address) {
    case kWwdgCr: {
      const bool too_early = state_.on && count() > (state_.configuration & kCounter);
      state_.on = state_.on || value & kActivate;
      state_.written = value & kCounter;
      state_.written_at = link_.clock.now;
      state_.told = false;
      if (state_.on && (too_early || state_.written < kLast)) link_.reset_cause = Reset::window_watchdog;
      return true;
    }
    case kWwdgCfr:
      // Software can set EWI but not clear it (20.6.2).
      state_.written = count();
      state_.written_at = link_.clock.now;
      state_.configuration = (value & 0x3FF) | (state_.configuration & kEarlyWakeup);
      return true;
    default:
      state_.early = state_.early && value & 1;
      link_.nvic.set_line(kIrqWwdg, state_.early && state_.configuration & kEarlyWakeup);
      return true;
  }
}

void WindowWatchdog::reset(Address) {
  state_.configuration = state_.written = 0x7F;
  state_.on = state_.early = state_.told = false;
  link_.nvic.set_line(kIrqWwdg, false);
}

}  // namespace robosim::exec::stm32
