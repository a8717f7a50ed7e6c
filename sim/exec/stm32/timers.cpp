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
  link.snapshots.add(state_);
  usual_pins_.fill(kNoChipPin);
  for (int i = 0; i < kStm32f103c8.pin_count; ++i)
    if (const auto& pin = kStm32f103c8.pins[i]; pin.timer == index)
      usual_pins_[pin.output] = {pin.port, pin.bit};
}

// Updates the interrupt lines. TIM1 has four interrupts; the other timers have one interrupt each (RM0008
// table 63).
void Timer::refresh_lines() {
  constexpr std::uint32_t kChannelEvents = 0x1E, kTriggers = kComEvent | kTriggerEvent;
  const std::uint32_t asks = state_.status & state_.interrupts;
  if (!advanced()) return link_.nvic.set_line(irq_, asks & (kUif | kChannelEvents | kTriggers));
  link_.nvic.set_line(irq_, asks & kUif);
  link_.nvic.set_line(kIrqTim1Trigger, asks & kTriggers);
  link_.nvic.set_line(kIrqTim1Capture, asks & kChannelEvents);
  link_.nvic.set_line(kIrqTim1Break, asks & kBreakEvent);
}

void Timer::reset(Address) {
  state_ = {};
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
      state_.status &= ~channel_event(channel);
      refresh_lines();
    }
    return state_.waiting_compare[static_cast<std::size_t>(channel)];
  }
  switch (offset) {
    case kTimCr1: {
      const bool down = centered() && is_clocked() && place(link_.clock.now) >= std::int64_t{state_.top};
      return state_.control | (down ? kDir : 0);
    }
    case kTimCr2:
      return state_.control2;
    case kTimSmcr:
      return state_.slave;
    case kTimDier:
      return state_.interrupts;
    case kTimSr:
      return state_.status;
    case kTimCcmr1:
      return state_.waiting_modes[0];
    case kTimCcmr2:
      return state_.waiting_modes[1];
    case kTimCcer:
      return state_.waiting_outputs;
    case kTimCnt:
      return count(link_.clock.now);
    case kTimPsc:
      return state_.waiting_prescaler;
    case kTimArr:
      return state_.waiting_top;
    case kTimRcr:
      return state_.repetition;
    case kTimBdtr:
      return state_.dead_time;
    default:
      return 0;
  }
}

bool Timer::slave_is_modelled() const {
  const std::uint32_t slave_mode = state_.slave & 7, from = state_.slave >> 4 & 7;
  if (state_.slave & kExternalClock) return false;
  return slave_mode < kResets || (slave_mode != kGates && from != kExternal);
}

bool Timer::write_compare(std::size_t channel, std::uint32_t value) {
  if (state_.waiting_compare[channel] == value && state_.compare[channel] == value) return true;
  state_.waiting_compare[channel] = value;
  if (mode(static_cast<int>(channel)) & kPreload && enabled()) return true;
  state_.compare[channel] = value;
  link_.pin_changed(pin_of(static_cast<int>(channel)));
  return true;
}

void Timer::commutate() {
  state_.modes = state_.waiting_modes;
  state_.outputs = state_.waiting_outputs;
  for (int channel = 0; channel < kChannels; ++channel) {
    const std::uint32_t how = mode(channel) >> 4 & 7;
    if (how == 4 || how == 5) state_.active[static_cast<std::size_t>(channel)] = how == 5;
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
      state_.held = before;
      state_.steps_down = value & kDir;
      state_.control = value & (kCen | kUdis | kUrs | kOpm | kDir | kCms | kArpe | kCkd);
      start_from(before, now);
      refresh_pins();
      if (value & kCen && (state_.control2 >> kMmsShift & 7) == 1) link_.signal(signal_of(number(), 0));
      return true;
    case kTimCr2:
      state_.control2 = value;
      return true;
    case kTimSmcr:
      state_.held = before;
      state_.slave = value;
      start_from(before, now);
      link_.watch_changed();
      return slave_is_modelled();
    case kTimDier:
      state_.interrupts = value;
      return true;
    case kTimSr:
      state_.status &= value;
      return true;
    case kTimEgr:
      if (value & kUg) {
        update_event(!(state_.control & kUrs));
        if ((state_.control2 >> kMmsShift & 7) == 0) link_.signal(signal_of(number(), 0));
        start_from(counts_down() && !centered() ? state_.top : 0, now);
      }
      for (int channel = 0; channel < kChannels; ++channel) {
        if (!(value & channel_event(channel))) continue;
        if (captures(channel))
          capture(channel, now);
        else
          captured_or_compared(channel);
      }
      state_.status |= value & (kComEvent | kTriggerEvent | kBreakEvent);
      if (value & kComEvent && state_.control2 & kCcpc) commutate();
      if (value & kBreakEvent) state_.dead_time &= ~kMoe;
      refresh_pins();
      return true;
    case kTimCcmr1:
    case kTimCcmr2:
      state_.waiting_modes[offset == kTimCcmr2] = value;
      if (!(state_.control2 & kCcpc)) commutate();
      return true;
    case kTimCcer:
      state_.waiting_outputs = value;
      if (!(state_.control2 & kCcpc)) commutate();
      return true;
    case kTimCnt:
      start_from(value, now);
      return true;
    case kTimPsc:
      state_.waiting_prescaler = value;
      return true;
    case kTimArr:
      state_.waiting_top = value;
      if (state_.control & kArpe && enabled()) return true;
      state_.top = value;
      start_from(before, now);
      refresh_pins();
      return true;
    case kTimRcr:
      state_.repetition = value & 0xFF;
      return advanced() || value == 0;
    case kTimBdtr:
      state_.dead_time = value;
      refresh_pins();
      return advanced() && (value & 1u << 12) == 0;  // the break input is not modelled
    default:
      return value == 0;  // TIM_DCR, TIM_DMAR
  }
}

}  // namespace robosim::exec::stm32
