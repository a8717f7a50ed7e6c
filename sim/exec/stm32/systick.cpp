#include "sim/exec/stm32/systick.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

std::uint32_t SysTick::value() const {
  if (!runs()) return state_.held;
  const Cycle left = state_.zero_at - link_.clock.now;  // never negative, since update() has been called
  const Cycle steps = by_eight() ? (left + 7) / 8 : left;
  return static_cast<std::uint32_t>(steps > state_.load ? 0 : steps);
}

void SysTick::set_value(std::uint32_t value) {
  state_.held = value;
  // A counter at 0 is reloaded from LOAD in the next step, and then counts down to 0.
  const Cycle steps = value == 0 ? Cycle{state_.load} + 1 : value;
  state_.zero_at = link_.clock.now + steps * (by_eight() ? 8 : 1);
}

std::uint32_t SysTick::read(Address address) {
  update();
  switch (address) {
    case kStkCtrl: {
      const std::uint32_t flag = state_.counted ? kCountFlag : 0;
      state_.counted = false;
      return state_.control | flag;
    }
    case kStkLoad:
      return state_.load;
    case kStkVal:
      return value();
    default:
      return 9000;  // STK_CALIB: 1 ms at 72 MHz / 8
  }
}

void SysTick::reset(Address) {
  state_.control = state_.load = state_.held = 0;
  state_.zero_at = 0;
  state_.counted = false;
}

bool SysTick::write(Address address, std::uint32_t value_written) {
  update();
  const std::uint32_t before = value();
  switch (address) {
    case kStkCtrl:
      state_.control = value_written & (kStkEnable | kTickInt | kClkSource);
      set_value(before);
      return true;
    case kStkLoad:
      if (value_written != 0 && state_.load != 0 && runs()) {
        state_.load = value_written & 0xFFFFFF;  // takes effect at the next reload
        return true;
      }
      state_.load = value_written & 0xFFFFFF;
      set_value(before);
      return true;
    case kStkVal:
      state_.counted = false;
      set_value(0);
      return true;
    default:
      return true;
  }
}

Cycle SysTick::same_until(Address address) const {
  if (address == kStkCtrl) return state_.counted ? 0 : runs() ? state_.zero_at : kNoCycle;
  return address == kStkVal && runs() ? 0 : kNoCycle;
}

Cycle SysTick::next_event() const { return runs() && state_.control & kTickInt ? state_.zero_at : kNoCycle; }

void SysTick::update() {
  if (!runs() || link_.clock.now < state_.zero_at) return;
  state_.counted = true;
  if (state_.control & kTickInt) link_.nvic.pend(robosim::exec::stm32::kSysTick);
  const Cycle rounds = (link_.clock.now - state_.zero_at) / period() + 1;
  state_.zero_at += rounds * period();
}

}  // namespace robosim::exec::stm32
