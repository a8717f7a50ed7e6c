#include "sim/exec/stm32/systick.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

std::uint32_t SysTick::value() const {
  if (!runs()) return held_;
  const Cycle left = zero_at_ - link_.clock.now;  // update() has been called: never negative
  const Cycle steps = by_eight() ? (left + 7) / 8 : left;
  return static_cast<std::uint32_t>(steps > load_ ? 0 : steps);
}

void SysTick::set_value(std::uint32_t value) {
  held_ = value;
  // From 0 it loads LOAD at the next step.
  const Cycle steps = value == 0 ? Cycle{load_} + 1 : value;
  zero_at_ = link_.clock.now + steps * (by_eight() ? 8 : 1);
}

std::uint32_t SysTick::read(Address address) {
  update();
  switch (address) {
    case kStkCtrl: {
      const std::uint32_t flag = counted_ ? kCountFlag : 0;
      counted_ = false;
      return control_ | flag;
    }
    case kStkLoad:
      return load_;
    case kStkVal:
      return value();
    default:
      return 9000;  // STK_CALIB: 1 ms at 72 MHz / 8
  }
}

void SysTick::reset(Address) {
  control_ = load_ = held_ = 0;
  zero_at_ = 0;
  counted_ = false;
}

bool SysTick::write(Address address, std::uint32_t value_written) {
  update();
  const std::uint32_t before = value();
  switch (address) {
    case kStkCtrl:
      control_ = value_written & (kStkEnable | kTickInt | kClkSource);
      set_value(before);
      return true;
    case kStkLoad:
      if (value_written != 0 && load_ != 0 && runs()) {
        load_ = value_written & 0xFFFFFF;  // counts from the next round on
        return true;
      }
      load_ = value_written & 0xFFFFFF;
      set_value(before);
      return true;
    case kStkVal:
      counted_ = false;
      set_value(0);
      return true;
    default:
      return true;
  }
}

Cycle SysTick::same_until(Address address) const {
  if (address == kStkCtrl) return counted_ ? 0 : runs() ? zero_at_ : kNoCycle;
  return address == kStkVal && runs() ? 0 : kNoCycle;
}

Cycle SysTick::next_event() const { return runs() && control_ & kTickInt ? zero_at_ : kNoCycle; }

void SysTick::update() {
  if (!runs() || link_.clock.now < zero_at_) return;
  counted_ = true;
  if (control_ & kTickInt) link_.nvic.pend(robosim::exec::stm32::kSysTick);
  const Cycle rounds = (link_.clock.now - zero_at_) / period() + 1;
  zero_at_ += rounds * period();
}

}  // namespace robosim::exec::stm32
