#include "sim/exec/stm32/timers.h"

#include "sim/exec/stm32/timer_bits.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

Timer::Timer(Link& link, const Clocks& clocks, int index)
    : link_(link),
      clocks_(clocks),
      index_(index),
      base_(kStm32f103c8.timers[index].control),
      irq_(static_cast<Irq>(kStm32f103c8.timers[index].vector)) {
  usual_pins_.fill(kNoChipPin);
  for (int i = 0; i < kStm32f103c8.pin_count; ++i)
    if (const auto& pin = kStm32f103c8.pins[i]; pin.timer == index)
      usual_pins_[pin.output] = {pin.port, pin.bit};
}

// RM0008 table 63: TIM1 has four interrupts, the others have one.
void Timer::refresh_lines() {
  constexpr std::uint32_t kChannelEvents = 0x1E, kTriggers = kComEvent | kTriggerEvent;
  const std::uint32_t asks = status_ & interrupts_;
  if (!advanced()) return link_.nvic.set_line(irq_, asks & (kUif | kChannelEvents | kTriggers));
  link_.nvic.set_line(irq_, asks & kUif);
  link_.nvic.set_line(kIrqTim1Trigger, asks & kTriggers);
  link_.nvic.set_line(kIrqTim1Capture, asks & kChannelEvents);
  link_.nvic.set_line(kIrqTim1Break, asks & kBreakEvent);
}

void Timer::reset(Address) {
  static_cast<TimerRegisters&>(*this) = {};
  refresh_lines();
  refresh_pins();
  link_.watch_changed();
}

std::uint32_t Timer::read(Address address) {
  update();
  const Address offset = address - base_;
  if (offset >= kTimCcr1 && offset < kTimCcr1 + 16) {
    const auto channel = static_cast<int>((offset - kTimCcr1) / 4);
    if (captures(channel)) {
      status_ &= ~channel_event(channel);
      refresh_lines();
    }
    return waiting_compare_[static_cast<std::size_t>(channel)];
  }
  switch (offset) {
    case kTimCr1: {
      const bool down = centered() && is_clocked() && place(link_.clock.now) >= std::int64_t{top_};
      return control_ | (down ? kDir : 0);
    }
    case kTimCr2:
      return control2_;
    case kTimSmcr:
      return slave_;
    case kTimDier:
      return interrupts_;
    case kTimSr:
      return status_;
    case kTimCcmr1:
      return waiting_modes_[0];
    case kTimCcmr2:
      return waiting_modes_[1];
    case kTimCcer:
      return waiting_outputs_;
    case kTimCnt:
      return count(link_.clock.now);
    case kTimPsc:
      return waiting_prescaler_;
    case kTimArr:
      return waiting_top_;
    case kTimRcr:
      return repetition_;
    case kTimBdtr:
      return dead_time_;
    default:
      return 0;
  }
}

bool Timer::slave_is_modelled() const {
  const std::uint32_t slave_mode = slave_ & 7, from = slave_ >> 4 & 7;
  if (slave_ & kExternalClock) return false;
  return slave_mode < kResets || (slave_mode != kGates && from != kExternal);
}

bool Timer::write_compare(std::size_t channel, std::uint32_t value) {
  if (waiting_compare_[channel] == value && compare_[channel] == value) return true;
  waiting_compare_[channel] = value;
  if (mode(static_cast<int>(channel)) & kPreload && enabled()) return true;
  compare_[channel] = value;
  link_.pin_changed(pin_of(static_cast<int>(channel)));
  return true;
}

void Timer::commutate() {
  modes_ = waiting_modes_;
  outputs_ = waiting_outputs_;
  for (int channel = 0; channel < kChannels; ++channel) {
    const std::uint32_t how = mode(channel) >> 4 & 7;
    if (how == 4 || how == 5) active_[static_cast<std::size_t>(channel)] = how == 5;
  }
  refresh_pins();
  link_.watch_changed();
}

bool Timer::write(Address address, std::uint32_t value) {
  update();
  const bool modelled = write_register(address - base_, value & 0xFFFF);
  refresh_lines();
  return modelled;
}

bool Timer::write_register(Address offset, std::uint32_t value) {
  if (offset >= kTimCcr1 && offset < kTimCcr1 + 16) return write_compare((offset - kTimCcr1) / 4, value);
  const Cycle now = link_.clock.now;
  const std::uint32_t before = count(now);
  switch (offset) {
    case kTimCr1:
      held_ = before;
      steps_down_ = value & kDir;
      control_ = value & (kCen | kUdis | kUrs | kOpm | kDir | kCms | kArpe | kCkd);
      start_from(before, now);
      refresh_pins();
      if (value & kCen && (control2_ >> kMmsShift & 7) == 1) link_.signal(signal_of(number(), 0));
      return true;
    case kTimCr2:
      control2_ = value;
      return true;
    case kTimSmcr:
      held_ = before;
      slave_ = value;
      start_from(before, now);
      link_.watch_changed();
      return slave_is_modelled();
    case kTimDier:
      interrupts_ = value;
      return true;
    case kTimSr:
      status_ &= value;
      return true;
    case kTimEgr:
      if (value & kUg) {
        update_event(!(control_ & kUrs));
        if ((control2_ >> kMmsShift & 7) == 0) link_.signal(signal_of(number(), 0));
        start_from(counts_down() && !centered() ? top_ : 0, now);
      }
      for (int channel = 0; channel < kChannels; ++channel) {
        if (!(value & channel_event(channel))) continue;
        if (captures(channel))
          capture(channel, now);
        else
          captured_or_compared(channel);
      }
      status_ |= value & (kComEvent | kTriggerEvent | kBreakEvent);
      if (value & kComEvent && control2_ & kCcpc) commutate();
      if (value & kBreakEvent) dead_time_ &= ~kMoe;
      refresh_pins();
      return true;
    case kTimCcmr1:
    case kTimCcmr2:
      waiting_modes_[offset == kTimCcmr2] = value;
      if (!(control2_ & kCcpc)) commutate();
      return true;
    case kTimCcer:
      waiting_outputs_ = value;
      if (!(control2_ & kCcpc)) commutate();
      return true;
    case kTimCnt:
      start_from(value, now);
      return true;
    case kTimPsc:
      waiting_prescaler_ = value;
      return true;
    case kTimArr:
      waiting_top_ = value;
      if (control_ & kArpe && enabled()) return true;
      top_ = value;
      start_from(before, now);
      refresh_pins();
      return true;
    case kTimRcr:
      repetition_ = value & 0xFF;
      return advanced() || value == 0;
    case kTimBdtr:
      dead_time_ = value;
      refresh_pins();
      return advanced() && (value & 1u << 12) == 0;  // no break input
    default:
      return value == 0;  // TIM_DCR, TIM_DMAR
  }
}

}  // namespace robosim::exec::stm32
