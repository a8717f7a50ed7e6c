// Models the timers' counter (RM0008 14.3.2, 15.3.2).
#include <algorithm>
#include <utility>

#include "sim/exec/stm32/timer_bits.h"
#include "sim/exec/stm32/timers.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

// Returns whether the internal clock drives the counter. Otherwise an encoder or a trigger drives the
// counter, or the counter is stopped.
bool Timer::is_clocked() const {
  const std::uint32_t slave_mode = state_.slave & 7;
  return enabled() && (slave_mode == 0 || (slave_mode >= kResets && slave_mode <= kStarts));
}

std::int64_t Timer::period() const {
  return centered() ? std::max<std::int64_t>(2 * std::int64_t{state_.top}, 1) : std::int64_t{state_.top} + 1;
}

std::uint32_t Timer::count_at(std::int64_t place) const {
  const std::int64_t top = state_.top, here = std::clamp<std::int64_t>(place, 0, period() - 1);
  if (centered()) return static_cast<std::uint32_t>(here <= top ? here : 2 * top - here);
  return static_cast<std::uint32_t>(counts_down() ? top - here : here);
}

std::uint32_t Timer::count(Cycle at) const { return is_clocked() ? count_at(place(at)) : state_.held; }

void Timer::start_from(std::uint32_t count, Cycle at) {
  state_.held = count;
  if (!is_clocked()) return;
  const std::int64_t top = state_.top, value = std::min<std::int64_t>(count, top);
  std::int64_t here = counts_down() && !centered() ? top - value : value;
  if (centered() && state_.steps_down && value > 0 && value < top) here = 2 * top - value;
  state_.step = (Cycle{state_.prescaler} + 1) * clocks_.timer_divider(base_);
  // The origin may lie before power-on, so that the subtraction wraps around. This is correct, because only
  // differences from the origin are used.
  state_.origin = at - static_cast<Cycle>(here) * state_.step;
  state_.done = here;
}

std::array<std::int64_t, 2> Timer::places_of(int channel) const {
  const std::int64_t top = state_.top, value = state_.compare[static_cast<std::size_t>(channel)];
  if (captures(channel) || value > top) return {-1, -1};
  if (!centered()) return {counts_down() ? top - value : value, -1};
  // CMS selects whether the counter sets flags while it counts down, up, or in both directions.
  const std::uint32_t aligned = state_.control >> 5 & 3;
  return {aligned & 2 ? value : -1, aligned & 1 && value > 0 ? 2 * top - value : -1};
}

bool Timer::needs_update_event() const {
  const bool waits = state_.prescaler != state_.waiting_prescaler || state_.top != state_.waiting_top ||
                     state_.compare != state_.waiting_compare;
  const std::uint32_t master = state_.control2 >> kMmsShift & 7;
  return state_.interrupts & (kUie | kUde) || state_.control & kOpm || waits ||
         (master >= 2 && link_.listened_to & signal_of(number(), 0));
}

bool Timer::needs_compare_event(int channel) const {
  if (captures(channel)) return false;
  const bool switches = is_on(channel) && (mode(channel) & 0x70) >= 0x10 && (mode(channel) & 0x70) <= 0x30;
  const bool master = (state_.control2 >> kMmsShift & 7) >= 3 && link_.listened_to & signal_of(number(), 0);
  return switches || master || state_.interrupts & (channel_event(channel) | channel_dma(channel)) ||
         link_.listened_to & signal_of(number(), channel + 1);
}

Cycle Timer::next_event() const {
  if (!is_clocked()) return kNoCycle;
  std::int64_t next = std::int64_t{1} << 40;
  const std::int64_t whole = period();
  const auto consider = [&](std::int64_t place) {
    if (place >= 0) next = std::min(next, place > state_.done ? place : place + whole);
  };
  if (needs_update_event()) {
    consider(whole);
    if (centered()) consider(state_.top);
  }
  for (int channel = 0; channel < kChannels; ++channel)
    if (needs_compare_event(channel))
      for (const std::int64_t place : places_of(channel)) consider(place);
  return next == std::int64_t{1} << 40 ? kNoCycle : state_.origin + static_cast<Cycle>(next) * state_.step;
}

// Skips whole periods if their events have no effect except flags, and sets these flags.
void Timer::fall_behind(std::int64_t place) {
  const std::int64_t periods = place / period() - 1;
  if (periods <= 0 || needs_update_event()) return;
  for (int channel = 0; channel < kChannels; ++channel)
    if (needs_compare_event(channel)) return;
  for (int channel = 0; channel < kChannels; ++channel)
    if (const auto places = places_of(channel); places[0] >= 0 || places[1] >= 0)
      state_.status |= channel_event(channel);
  if (!(state_.control & kUdis) && state_.repetition == 0) state_.status |= kUif;
  state_.origin += static_cast<Cycle>(periods * period()) * state_.step;
  state_.done = -1;
}

void Timer::update() {
  if (!is_clocked()) return;
  const Cycle now = link_.clock.now;
  fall_behind(place(now));
  while (is_clocked()) {
    const std::int64_t whole = period(), here = place(now);
    std::int64_t next = whole;
    const auto consider = [&](std::int64_t place) {
      if (place > state_.done) next = std::min(next, place);
    };
    if (centered()) consider(state_.top);
    for (int channel = 0; channel < kChannels; ++channel)
      for (const std::int64_t place : places_of(channel)) consider(place);
    if (next > here) break;
    state_.done = next;
    const Cycle at = state_.origin + static_cast<Cycle>(next) * state_.step;
    for (int channel = 0; channel < kChannels; ++channel)
      for (const std::int64_t place : places_of(channel))
        if (place == next) compared(channel);
    if (next == whole) {
      state_.origin = at;
      state_.done = -1;
    }
    if (next == whole || (centered() && next == state_.top)) overflow(at);
  }
  refresh_lines();
}

// Triggers an update event every RCR + 1 overflows (RM0008 14.3.3).
void Timer::overflow(Cycle at) {
  if (state_.repetitions_left > 0) {
    --state_.repetitions_left;
    return;
  }
  const std::int64_t here = state_.done;
  const bool one_pulse = state_.control & kOpm;
  if (one_pulse) {
    state_.held = counts_down() && !centered() ? state_.top : 0;
    state_.control &= ~kCen;
  }
  update_event(true);
  if (one_pulse) return refresh_pins();
  state_.step = (Cycle{state_.prescaler} + 1) * clocks_.timer_divider(base_);
  if (here > 0) state_.origin = at - static_cast<Cycle>(here) * state_.step;
}

void Timer::load_waiting() {
  const bool same = state_.top == state_.waiting_top && state_.compare == state_.waiting_compare &&
                    state_.prescaler == state_.waiting_prescaler;
  state_.prescaler = state_.waiting_prescaler;
  state_.top = state_.waiting_top;
  state_.compare = state_.waiting_compare;
  state_.repetitions_left = state_.repetition;
  if (!same) refresh_pins();
}

void Timer::update_event(bool flag) {
  if (state_.control & kUdis) return;
  load_waiting();
  if (flag) {
    state_.status |= kUif;
    if (state_.interrupts & kUde) {
      constexpr int kDma[] = {5, 2, 3, 7};  // table 78
      state_.dma_pending |= dma_channel(kDma[index_]);
    }
  }
  if ((state_.control2 >> kMmsShift & 7) == 2 || rises_at_update()) link_.signal(signal_of(number(), 0));
}

// Advances the counter by one step for an edge of an encoder or a trigger.
void Timer::step(bool up, Cycle at) {
  const bool before = std::exchange(state_.steps_down, !up);
  const bool over = up ? state_.held >= state_.top : state_.held == 0;
  state_.held = over ? (up ? 0 : state_.top) : up ? state_.held + 1 : state_.held - 1;
  if (before != state_.steps_down) state_.control = (state_.control & ~kDir) | (up ? 0 : kDir);
  for (int channel = 0; channel < kChannels; ++channel)
    if (!captures(channel) && state_.held == state_.compare[static_cast<std::size_t>(channel)])
      compared(channel);
  if (over) overflow(at);
  refresh_lines();
}

}  // namespace robosim::exec::stm32
