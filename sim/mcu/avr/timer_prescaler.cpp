#include "sim/mcu/avr/timer_prescaler.h"

#include "sim/mcu/avr/timer.h"

namespace robosim::avr {
namespace {

constexpr std::array<std::uint8_t, 2> kToZero{kPsrsync, kPsrasy};

}  // namespace

Prescalers::Prescalers(Core& core) : core_(core) {
  core.cpu.on_write<&Prescalers::write>(core.chip.at.timers, this);
  core.keep(state_);
}

void Prescalers::reset(Cycle at) {
  state_ = {};
  state_.began.fill(at);
}

void Prescalers::clock_runs(bool runs, Cycle at) {
  if (!runs) {
    state_.stopped = at;
    return;
  }
  for (Cycle& began : state_.began) began += at - state_.stopped;
}

void Prescalers::write(Address address, std::uint8_t value) {
  const Cycle now = core_.now();
  for (Timer* const timer : timers_) timer->count_to(now);
  const bool holds = value & kTsm;
  for (std::size_t i = 0; i < kToZero.size(); ++i) {
    const bool to_zero = value & kToZero[i];
    if (to_zero || state_.held[i]) state_.began[i] = now;
    state_.held[i] = to_zero && holds;
  }
  const std::uint8_t kept = core_.chip.at.timers_kept;
  core_.at(address) =
      static_cast<std::uint8_t>((holds ? value & (kTsm | kToZero[0] | kToZero[1]) : 0) | (value & kept));
  for (Timer* const timer : timers_) timer->settle();
}

}  // namespace robosim::avr
