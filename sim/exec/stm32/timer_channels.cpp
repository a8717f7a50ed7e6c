// Models the timers' channels at pins, and the signals that start or clock timers (RM0008 14.3.5 to 14.3.14,
// 14.3.16, 15.3.12, 15.3.14).
#include <algorithm>

#include "sim/exec/stm32/remap.h"
#include "sim/exec/stm32/timer_bits.h"
#include "sim/exec/stm32/timers.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// For each timer and each of its internal triggers, the timer whose TRGO is the trigger (table 86). 0 = a
// timer that the chip does not have.
constexpr int kInternalTriggers[4][4] = {{0, 2, 3, 4}, {1, 0, 3, 4}, {1, 2, 0, 4}, {1, 2, 3, 0}};
// DMA channel of each timer channel (table 78); 0 = none.
constexpr int kChannelDma[4][4] = {{2, 0, 6, 4}, {5, 7, 1, 7}, {6, 0, 2, 3}, {1, 4, 5, 0}};

}  // namespace

ChipPin Timer::pin_of(int channel) const {
  return timer_pin(number(), channel, link_.map, usual_pins_[static_cast<std::size_t>(channel)]);
}

bool Timer::is_pwm(int channel) const { return !captures(channel) && (mode(channel) & 0x60) == 0x60; }

// --- comparing

void Timer::captured_or_compared(int channel) {
  state_.status |= channel_event(channel);
  const int dma = kChannelDma[index_][channel];
  if (state_.interrupts & channel_dma(channel) && dma > 0) state_.dma_pending |= dma_channel(dma);
}

void Timer::compared(int channel) {
  captured_or_compared(channel);
  bool& active = state_.active[static_cast<std::size_t>(channel)];
  const bool before = active;
  switch (mode(channel) >> 4 & 7) {
    case 1:
      active = true;
      break;
    case 2:
      active = false;
      break;
    case 3:
      active = !active;
      break;
    default:
      break;
  }
  if (active != before) link_.pin_changed(pin_of(channel));
  const std::uint32_t master = state_.control2 >> kMmsShift & 7;
  const bool rises = active && !before;
  Signals signals = signal_of(number(), channel + 1);
  if ((master == 3 && channel == 0) ||
      (master == 4u + static_cast<unsigned>(channel) && (rises || (mode(channel) >> 4 & 7) == 7)))
    signals |= signal_of(number(), 0);
  link_.signal(signals);
}

// Returns the share of a period in which a PWM output is active (14.3.10).
double Timer::share_of(int channel) const {
  const auto value = static_cast<double>(state_.compare[static_cast<std::size_t>(channel)]);
  const double top = static_cast<double>(state_.top);
  const double share = centered()      ? (state_.top > 0 ? value / top : 1.0)
                       : counts_down() ? (value + 1.0) / (top + 1.0)
                                       : value / (top + 1.0);
  return std::min(share, 1.0);
}

std::uint32_t Timer::period_us() const {
  const std::uint64_t cycles =
      static_cast<std::uint64_t>(period()) * (state_.prescaler + 1) * clocks_.timer_divider(base_);
  return static_cast<std::uint32_t>(cycles * 1'000'000 / link_.clock.hz());
}

// Returns whether an output is inverted. If the main output is enabled, the complementary output is its
// inverse. Otherwise the complementary output is not inverted (table 83). In addition, each output has a
// polarity bit that can invert it.
bool Timer::inverts(int channel, bool complement) const {
  const std::uint32_t own = state_.outputs >> (4 * channel) & 15;
  const bool opposite = complement && own & 1;
  return opposite != bool(own & (complement ? 8 : 2));
}

PinDrive Timer::drive_of(int channel, bool complement) const {
  PinDrive drive;
  drive.mode = PinMode::output;
  const std::uint32_t own = state_.outputs >> (4 * channel) & 15;
  const bool on = complement ? own & 4 : own & 1;
  if (!on || captures(channel) || (advanced() && !(state_.dead_time & kMoe))) return drive;
  const bool inverted = inverts(channel, complement);
  const std::uint32_t how = mode(channel) >> 4 & 7;
  if (how < 6) {
    const bool active = how == 5 || (how < 4 && state_.active[static_cast<std::size_t>(channel)]);
    drive.level = active != inverted;
    return drive;
  }
  const double share = share_of(channel);
  drive.duty = (how == 7) != inverted ? 1.0 - share : share;
  drive.pwm = enabled();
  if (!drive.pwm) drive.duty = 0.0;
  if (drive.pwm) drive.period_us = period_us();
  return drive;
}

bool Timer::drives(ChipPin pin, PinDrive& drive) const {
  for (int channel = 0; channel < kChannels; ++channel) {
    const bool complement = advanced() && pin == complementary_pin(channel, link_.map);
    if (pin_of(channel) != pin && !complement) continue;
    if (captures(channel)) continue;
    drive = drive_of(channel, complement);
    return true;
  }
  return false;
}

// Returns OCxREF of PWM mode 1, and the cycle of its next change (14.3.10). Several periods may have passed
// since the last update().
Pulse Timer::pulse_of(int channel) const {
  const std::int64_t value = state_.compare[static_cast<std::size_t>(channel)], top = state_.top,
                     whole = period();
  const bool down = counts_down() && !centered();
  if (!is_clocked()) return {down ? state_.held <= value : state_.held < value, 0};
  const std::int64_t falls = down ? whole : value, rises = centered() ? 2 * top - value
                                                           : down     ? top - value
                                                                      : whole;
  const std::int64_t passed = place(link_.clock.now), here = passed % whole;
  std::int64_t next = whole;
  for (const std::int64_t change : {falls, rises})
    if (change > here) next = std::min(next, change);
  return {here >= rises || (!down && here < falls),
          state_.origin + static_cast<Cycle>(passed - here + next) * state_.step};
}

Pulse Timer::pulse(ChipPin pin) const {
  for (int channel = 0; channel < kChannels; ++channel) {
    const bool complement = advanced() && pin == complementary_pin(channel, link_.map);
    if ((pin_of(channel) != pin && !complement) || captures(channel)) continue;
    Pulse pulse = pulse_of(channel);
    const bool in_mode_2 = (mode(channel) >> 4 & 7) == 7;
    pulse.level = pulse.level != (in_mode_2 != inverts(channel, complement));
    return pulse;
  }
  return {};
}

void Timer::refresh_pins() {
  for (int channel = 0; channel < kChannels; ++channel) {
    link_.pin_changed(pin_of(channel));
    if (advanced()) link_.pin_changed(complementary_pin(channel, link_.map));
  }
}

// --- inputs

bool Timer::watches(ChipPin pin) const {
  for (int input = 0; input < kChannels; ++input) {
    if (pin_of(input) != pin) continue;
    const std::uint32_t slave_mode = state_.slave & 7, from = state_.slave >> 4 & 7;
    if (slave_mode >= kEncoder1 && slave_mode <= kEncoder3 && input < 2) return true;
    if (slave_mode >= kResets &&
        ((input == 0 && (from == kAnyEdgeOf1 || from == kInput1)) || (input == 1 && from == kInput2)))
      return true;
    // CCxS selects the input of a channel: 1 = the input of this channel, 2 = the input of the neighbouring
    // channel
    if ((mode(input) & 3) == 1 && is_on(input)) return true;
    if ((mode(input ^ 1) & 3) == 2 && is_on(input ^ 1)) return true;
  }
  return false;
}

void Timer::edge(ChipPin pin, bool level, Cycle at) {
  if (!watches(pin)) return;
  update();
  for (int input = 0; input < kChannels; ++input)
    if (pin_of(input) == pin) edge_of_input(input, level, at);
  refresh_lines();
}

void Timer::edge_of_input(int input, bool level, Cycle at) {
  const auto inverted = [&](int channel) { return bool(state_.outputs >> (4 * channel) & 2); };
  for (const int channel : {input, input ^ 1}) {
    const std::uint32_t source = channel == input ? 1 : 2;
    if ((mode(channel) & 3) == source && is_on(channel) && level != inverted(channel)) capture(channel, at);
  }
  if (!enabled() && (state_.slave & 7) != kStarts) return;
  const std::uint32_t slave_mode = state_.slave & 7, from = state_.slave >> 4 & 7;
  if (slave_mode >= kEncoder1 && slave_mode <= kEncoder3) {
    if (input > 1) return;
    const bool counts = slave_mode == kEncoder3 || (slave_mode == kEncoder1) == (input == 1);
    // The level of the other encoder signal determines the direction (table 85). Encoder mode 1 counts edges
    // of TI2, and mode 2 counts edges of TI1.
    const bool other = link_.pin_level(pin_of(input ^ 1)) != inverted(input ^ 1);
    const bool own = level != inverted(input);
    if (counts && enabled()) step((own == other) == (input == 1), at);
    return;
  }
  const bool chosen =
      (input == 0 && (from == kAnyEdgeOf1 || from == kInput1)) || (input == 1 && from == kInput2);
  if (!chosen) return;
  const bool rises = level != inverted(input);
  if (from == kAnyEdgeOf1 || rises) trigger(at);
}

void Timer::capture(int channel, Cycle at) {
  std::uint32_t& passed = state_.captures[static_cast<std::size_t>(channel)];
  const std::uint32_t every = 1u << (mode(channel) >> 2 & 3);
  if (++passed < every) return;
  passed = 0;
  if (state_.status & channel_event(channel)) state_.status |= overcapture(channel);
  state_.compare[static_cast<std::size_t>(channel)] =
      state_.waiting_compare[static_cast<std::size_t>(channel)] = count(at);
  captured_or_compared(channel);
}

// --- triggers

bool Timer::rises_at_update() const {
  const std::uint32_t master = state_.control2 >> kMmsShift & 7;
  return master >= 4 && (mode(static_cast<int>(master) - 4) >> 4 & 7) == 6;
}

Signals Timer::listens() const {
  const std::uint32_t from = state_.slave >> 4 & 7;
  if ((state_.slave & 7) < kResets || from >= 4) return 0;
  const int master = kInternalTriggers[index_][from];
  return master > 0 ? signal_of(master, 0) : 0;
}

void Timer::heard(Signals) {
  update();
  trigger(link_.clock.now);
  refresh_lines();
}

void Timer::trigger(Cycle at) {
  const std::uint32_t slave_mode = state_.slave & 7;
  if (slave_mode == kClocks) {
    step(!counts_down(), at);
    return;
  }
  state_.status |= kTriggerEvent;
  if (state_.control2 & kCcpc && state_.control2 & kCcus) {
    state_.status |= kComEvent;
    commutate();
  }
  if (slave_mode == kResets) {
    update_event(!(state_.control & kUrs));
    start_from(counts_down() && !centered() ? state_.top : 0, at);
  } else if (slave_mode == kStarts && !enabled()) {
    state_.control |= kCen;
    start_from(state_.held, at);
    refresh_pins();
  }
}

}  // namespace robosim::exec::stm32
