#include "sim/exec/stm32/timers.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

std::uint32_t Timer::count() const {
  if (!enabled()) return held_;
  const Cycle left = (update_at_ - link_.clock.now + step() - 1) / step();
  return left > Cycle{top_} + 1 ? 0 : static_cast<std::uint32_t>(Cycle{top_} + 1 - left);
}

void Timer::start_from(std::uint32_t count) {
  held_ = count;
  const Cycle left = count > top_ ? 1 : Cycle{top_} + 1 - count;
  update_at_ = link_.clock.now + left * step();
}

void Timer::update_event(bool flag) {
  prescaler_ = waiting_prescaler_;
  if (flag) status_ |= kUif;
  link_.nvic.set_line(place_.irq, status_ & interrupts_ & kUif);
}

void Timer::update() {
  if (!enabled() || link_.clock.now < update_at_) return;
  const Cycle at = update_at_;
  if (control_ & kOpm) {
    control_ &= ~kCen;
    held_ = 0;
  }
  update_event(true);
  if (!enabled()) return refresh();
  const Cycle rounds = (link_.clock.now - at) / period() + 1;
  update_at_ = at + rounds * period();
}

PinDrive Timer::drive_of(int channel) const {
  PinDrive drive;
  drive.mode = PinMode::output;
  const bool on = outputs_ >> (4 * channel) & 1 && (!advanced() || dead_time_ & kMoe);
  if (!on) return drive;
  const std::uint32_t mode = modes_[static_cast<std::size_t>(channel / 2)] >> (8 * (channel % 2)) & 0x70;
  const bool inverted = (mode == 0x70) != bool(outputs_ >> (4 * channel) & 2);
  const double share =
      static_cast<double>(compare_[static_cast<std::size_t>(channel)]) / static_cast<double>(Cycle{top_} + 1);
  drive.duty = share < 1.0 ? share : 1.0;
  if (inverted) drive.duty = 1.0 - drive.duty;
  drive.pwm = enabled();
  if (!drive.pwm) drive.duty = 0.0;
  return drive;
}

bool Timer::drives(ChipPin pin, PinDrive& drive) const {
  for (int channel = 0; channel < 4; ++channel) {
    if (place_.pins[static_cast<std::size_t>(channel)] != pin) continue;
    drive = drive_of(channel);
    return true;
  }
  return false;
}

void Timer::refresh() {
  for (const ChipPin pin : place_.pins) link_.pin_changed(pin);
}

void Timer::reset(Address) {
  static_cast<TimerRegisters&>(*this) = {};
  link_.nvic.set_line(place_.irq, false);
  refresh();
}

std::uint32_t Timer::read(Address address) {
  update();
  const Address offset = address - place_.base;
  if (offset >= kTimCcr1 && offset < kTimCcr1 + 16) return compare_[(offset - kTimCcr1) / 4];
  switch (offset) {
    case kTimCr1:
      return control_;
    case kTimCr2:
      return control2_;
    case kTimDier:
      return interrupts_;
    case kTimSr:
      return status_;
    case kTimCcmr1:
      return modes_[0];
    case kTimCcmr2:
      return modes_[1];
    case kTimCcer:
      return outputs_;
    case kTimCnt:
      return count();
    case kTimPsc:
      return waiting_prescaler_;
    case kTimArr:
      return top_;
    case kTimRcr:
      return repetition_;
    case kTimBdtr:
      return dead_time_;
    default:
      return 0;
  }
}

bool Timer::supported_modes() const {
  for (int channel = 0; channel < 4; ++channel) {
    const std::uint32_t byte = modes_[static_cast<std::size_t>(channel / 2)] >> (8 * (channel % 2)) & 0xFF;
    const std::uint32_t mode = byte & 0x70;
    if (byte & 3 || (mode != 0 && mode != 0x60 && mode != 0x70)) return false;
  }
  return true;
}

bool Timer::write(Address address, std::uint32_t value) {
  update();
  value &= 0xFFFF;
  const Address offset = address - place_.base;
  if (offset >= kTimCcr1 && offset < kTimCcr1 + 16) {
    const std::size_t channel = (offset - kTimCcr1) / 4;
    if (compare_[channel] == value) return true;
    compare_[channel] = value;
    link_.pin_changed(place_.pins[channel]);
    return true;
  }
  bool modelled = true;
  switch (offset) {
    case kTimCr1: {
      const std::uint32_t before = count();
      control_ = value;
      start_from(before);
      modelled = (value & ~(kCen | kUrs | kOpm | kArpe)) == 0;
      break;
    }
    case kTimDier:
      interrupts_ = value;
      link_.nvic.set_line(place_.irq, status_ & interrupts_ & kUif);
      return (value & ~kUie) == 0;
    case kTimSr:
      status_ &= value;
      link_.nvic.set_line(place_.irq, status_ & interrupts_ & kUif);
      return true;
    case kTimEgr:
      if (value & kUg) {
        update_event(!(control_ & kUrs));
        start_from(0);
      }
      return (value & ~kUg) == 0;
    case kTimCcmr1:
    case kTimCcmr2:
      modes_[offset == kTimCcmr2] = value;
      modelled = supported_modes();
      break;
    case kTimCcer:
      outputs_ = value;
      modelled = (value & 0xCCCC) == 0;  // no complementary outputs
      break;
    case kTimCnt:
      start_from(value);
      return true;
    case kTimPsc:
      waiting_prescaler_ = value;
      return true;
    case kTimArr: {
      const std::uint32_t before = count();
      top_ = value;
      start_from(before);
      break;
    }
    case kTimRcr:
      repetition_ = value;
      return value == 0;
    case kTimBdtr:
      dead_time_ = value;
      modelled = advanced() && (value & 0x0FFF) == 0;
      break;
    default:
      return value == 0;
  }
  refresh();
  return modelled;
}

}  // namespace robosim::exec::stm32
