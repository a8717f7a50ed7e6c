// The timers' counter (RM0008 14.3.2, 15.3.2).
#include <algorithm>
#include <utility>

#include "sim/exec/stm32/timer_bits.h"
#include "sim/exec/stm32/timers.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

// By the internal clock; an encoder's edges or a trigger may count instead.
bool Timer::is_clocked() const {
  const std::uint32_t slave_mode = slave_ & 7;
  return enabled() && (slave_mode == 0 || (slave_mode >= kResets && slave_mode <= kStarts));
}

std::int64_t Timer::period() const {
  return centered() ? std::max<std::int64_t>(2 * std::int64_t{top_}, 1) : std::int64_t{top_} + 1;
}

std::uint32_t Timer::count_at(std::int64_t place) const {
  const std::int64_t top = top_, here = std::clamp<std::int64_t>(place, 0, period() - 1);
  if (centered()) return static_cast<std::uint32_t>(here <= top ? here : 2 * top - here);
  return static_cast<std::uint32_t>(counts_down() ? top - here : here);
}

std::uint32_t Timer::count(Cycle at) const { return is_clocked() ? count_at(place(at)) : held_; }

void Timer::start_from(std::uint32_t count, Cycle at) {
  held_ = count;
  if (!is_clocked()) return;
  const std::int64_t top = top_, value = std::min<std::int64_t>(count, top);
  std::int64_t here = counts_down() && !centered() ? top - value : value;
  if (centered() && steps_down_ && value > 0 && value < top) here = 2 * top - value;
  step_ = (Cycle{prescaler_} + 1) * clocks_.timer_divider(base_);
  // Before the chip began, perhaps: only differences matter.
  origin_ = at - static_cast<Cycle>(here) * step_;
  done_ = here;
}

std::array<std::int64_t, 2> Timer::places_of(int channel) const {
  const std::int64_t top = top_, value = compare_[static_cast<std::size_t>(channel)];
  if (captures(channel) || value > top) return {-1, -1};
  if (!centered()) return {counts_down() ? top - value : value, -1};
  // CMS: flags while counting down, up, or both.
  const std::uint32_t aligned = control_ >> 5 & 3;
  return {aligned & 2 ? value : -1, aligned & 1 && value > 0 ? 2 * top - value : -1};
}

bool Timer::needs_update_event() const {
  const bool waits = prescaler_ != waiting_prescaler_ || top_ != waiting_top_ || compare_ != waiting_compare_;
  const std::uint32_t master = control2_ >> kMmsShift & 7;
  return interrupts_ & (kUie | kUde) || control_ & kOpm || waits ||
         (master >= 2 && link_.listened_to & signal_of(number(), 0));
}

bool Timer::needs_compare_event(int channel) const {
  if (captures(channel)) return false;
  const bool switches = is_on(channel) && (mode(channel) & 0x70) >= 0x10 && (mode(channel) & 0x70) <= 0x30;
  const bool master = (control2_ >> kMmsShift & 7) >= 3 && link_.listened_to & signal_of(number(), 0);
  return switches || master || interrupts_ & (channel_event(channel) | channel_dma(channel)) ||
         link_.listened_to & signal_of(number(), channel + 1);
}

Cycle Timer::next_event() const {
  if (!is_clocked()) return kNoCycle;
  std::int64_t next = std::int64_t{1} << 40;
  const std::int64_t whole = period();
  const auto consider = [&](std::int64_t place) {
    if (place >= 0) next = std::min(next, place > done_ ? place : place + whole);
  };
  if (needs_update_event()) {
    consider(whole);
    if (centered()) consider(top_);
  }
  for (int channel = 0; channel < kChannels; ++channel)
    if (needs_compare_event(channel))
      for (const std::int64_t place : places_of(channel)) consider(place);
  return next == std::int64_t{1} << 40 ? kNoCycle : origin_ + static_cast<Cycle>(next) * step_;
}

// Whole periods in which nobody listened: flags are all that is left of them.
void Timer::fall_behind(std::int64_t place) {
  const std::int64_t periods = place / period() - 1;
  if (periods <= 0 || needs_update_event()) return;
  for (int channel = 0; channel < kChannels; ++channel)
    if (needs_compare_event(channel)) return;
  for (int channel = 0; channel < kChannels; ++channel)
    if (const auto places = places_of(channel); places[0] >= 0 || places[1] >= 0)
      status_ |= channel_event(channel);
  if (!(control_ & kUdis) && repetition_ == 0) status_ |= kUif;
  origin_ += static_cast<Cycle>(periods * period()) * step_;
  done_ = -1;
}

void Timer::update() {
  if (!is_clocked()) return;
  const Cycle now = link_.clock.now;
  fall_behind(place(now));
  while (is_clocked()) {
    const std::int64_t whole = period(), here = place(now);
    std::int64_t next = whole;
    const auto consider = [&](std::int64_t place) {
      if (place > done_) next = std::min(next, place);
    };
    if (centered()) consider(top_);
    for (int channel = 0; channel < kChannels; ++channel)
      for (const std::int64_t place : places_of(channel)) consider(place);
    if (next > here) break;
    done_ = next;
    const Cycle at = origin_ + static_cast<Cycle>(next) * step_;
    for (int channel = 0; channel < kChannels; ++channel)
      for (const std::int64_t place : places_of(channel))
        if (place == next) compared(channel);
    if (next == whole) {
      origin_ = at;
      done_ = -1;
    }
    if (next == whole || (centered() && next == top_)) overflow(at);
  }
  refresh_lines();
}

// RM0008 14.3.3: an update each RCR + 1 overflows.
void Timer::overflow(Cycle at) {
  if (repetitions_left_ > 0) {
    --repetitions_left_;
    return;
  }
  const std::int64_t here = done_;
  const bool one_pulse = control_ & kOpm;
  if (one_pulse) {
    held_ = counts_down() && !centered() ? top_ : 0;
    control_ &= ~kCen;
  }
  update_event(true);
  if (one_pulse) return refresh_pins();
  step_ = (Cycle{prescaler_} + 1) * clocks_.timer_divider(base_);
  if (here > 0) origin_ = at - static_cast<Cycle>(here) * step_;
}

void Timer::load_waiting() {
  const bool same = top_ == waiting_top_ && compare_ == waiting_compare_ && prescaler_ == waiting_prescaler_;
  prescaler_ = waiting_prescaler_;
  top_ = waiting_top_;
  compare_ = waiting_compare_;
  repetitions_left_ = repetition_;
  if (!same) refresh_pins();
}

void Timer::update_event(bool flag) {
  if (control_ & kUdis) return;
  load_waiting();
  if (flag) {
    status_ |= kUif;
    if (interrupts_ & kUde) {
      constexpr int kDma[] = {5, 2, 3, 7};  // table 78
      dma_pending_ |= dma_channel(kDma[index_]);
    }
  }
  if ((control2_ >> kMmsShift & 7) == 2 || rises_at_update()) link_.signal(signal_of(number(), 0));
}

// By an edge of another clock.
void Timer::step(bool up, Cycle at) {
  const bool before = std::exchange(steps_down_, !up);
  const bool over = up ? held_ >= top_ : held_ == 0;
  held_ = over ? (up ? 0 : top_) : up ? held_ + 1 : held_ - 1;
  if (before != steps_down_) control_ = (control_ & ~kDir) | (up ? 0 : kDir);
  for (int channel = 0; channel < kChannels; ++channel)
    if (!captures(channel) && held_ == compare_[static_cast<std::size_t>(channel)]) compared(channel);
  if (over) overflow(at);
  refresh_lines();
}

}  // namespace robosim::exec::stm32
