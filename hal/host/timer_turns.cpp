// Handles deviations of a timer from its regular period (data sheet, 15.7, 16.9): PWM values that take effect
// later, a count above TOP, and a change of TOP. A deviation ends at a turn: the counter restarts with the
// present register values. Columns: the cause, the course of the count until the turn, the time of the turn.
//
//   OCRnA is TOP, new value pending      unchanged                              when the value takes effect
//   above TOP, counting up               to MAX, then 0                         at 0
//   above TOP, counting down             down, as if TOP were its start         at BOTTOM
#include "hal/host/clock.h"
#include "hal/host/external.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

Timer::Phase Timer::leave_registers() {
  if (captures_edges()) hear();
  sync_waves();
  sync();
  sync_disabled();
  const int64_t now = ticks();
  for (int channel = 0; channel < 2; ++channel) {
    keep_level(channel, now);
    if (!is_held(channel)) replaced_at_[channel] = -1;
  }
  return {count(), counts_down(now), now < hidden_, prescaler_, prescaler_ == 0 ? state.now : time_of(now)};
}

/// Restarts the counter at the time `base_`. Buffered PWM values remain. `hidden` means that TCNTn was just
/// written (15.5.3).
void Timer::begin(uint16_t count, bool down, bool hidden) {
  const bool pwm = counting_.kind == avr::Counting::Kind::pwm;
  dual_slope_ = counting_.dual_slope;
  down = down && dual_slope_;
  for (SimTime& time : replaced_at_)
    if (time >= 0) time = pwm ? base_ : -1;
  const uint16_t compare_a = replaced_at_[0] >= 0 ? held_[0] : compare_[0];
  const int64_t top = pin_top_ = avr::top_of(counting_, compare_a, capture_);
  // A write of TOP or BOTTOM to TCNTn hides the match with this value. A count down from TOP never matches
  // TOP.
  const bool passes_bottom = hidden && down && count == 0;
  if (count == 0 && top == 0 && down && !hidden) {
    strays_ = true;
    down = false;
  } else {
    const bool passes_top = hidden && !down && count == top && counting_.top != avr::Counting::Top::fixed;
    strays_ = count > top || (down && count == top) || passes_top || passes_bottom;
  }
  if (strays_ && !down) dual_slope_ = false;
  top_ = !strays_ ? top : down && !passes_bottom ? count : max_;
  period_ = !dual_slope_ ? top_ + 1 : top_ > 0 ? 2 * top_ : 1;
  lasts_ = kCycles.at_least(period_ * prescaler_);
  base_tick_ = passes_bottom ? top_ - 1 : down ? 2 * top_ - count : count;
  overflows_seen_ = disabled_seen_ = base_tick_;
  hidden_ = hidden ? base_tick_ + 1 : kLongAgo;
  for (int64_t& tick : toggled_at_) tick = base_tick_;
  turn_ = strays_ ? period_ : kNoTick;
  if (is_top(0)) turn_where_taken_over();
}

void Timer::turn() {
  const SimTime at = time_of(turn_);
  for (int flag = 0; flag < flag_count_; ++flag)
    if (due_of_[flag] <= at) flags_ |= bit_of(flag);
  if (prescaler_ != 0) sync_disabled(turn_);
  for (int channel = 0; channel < 2; ++channel) {
    keep_level(channel, turn_);
    if (replaced_at_[channel] >= 0) replaced_at_[channel] = turn_ < held_until(channel) ? at : -1;
  }
  base_ = at;
  begin(count_at(turn_), counts_down(turn_), false);
  pins_stale_ = true;
  refresh_due(base_tick_);
}

/// Handles all turns up to now. Updates the pins, because turns and new compare values may change them.
void Timer::take_turns() {
  sync_waves();
  while (state.now >= turns_at_) turn();
  for (int channel = 0; channel < 2; ++channel)
    if (!is_held(channel)) late_ &= static_cast<uint8_t>(~(1 << channel));
  pins_stale_ = false;
  refresh_turn();
  refresh_timer_pins(number_);
  refresh_waves();
}

// Finds the next turn, or an earlier time at which a pin must be updated: when a compare value takes effect,
// or at a match.
void Timer::refresh_turn() {
  turns_at_ = turn_ == kNoTick || prescaler_ == 0 ? kNever : time_of(turn_);
  turn_due_ = pins_stale_ ? 0 : turns_at_;
  if (prescaler_ == 0 || !(late_ || steps())) return;
  for (int channel = 0; channel < 2; ++channel) {
    SimTime due = kNever;
    if (late_ >> channel & 1) {
      const int64_t until = held_until(channel);
      if (until != kNoTick) due = until == kLongAgo ? 0 : time_of(until);
    }
    if (drives(channel) && steps(channel)) {
      const uint8_t connected = connection(channel);
      if (connected == 1 || level_at(channel, ticks()) != (connected == 3)) due = next(channel + 1, ticks());
    }
    if (due < turn_due_) turn_due_ = due;
  }
}

/// Returns whether the board receives each level of a channel's pin, instead of PWM or a tone. This is true
/// in three cases: the timer has no clock; the pin toggles (COM = 1) at less than 20 Hz; COM is 2 or 3
/// without PWM.
bool Timer::steps(int channel) const {
  constexpr int64_t kLowestTone_hz = 20;
  if (prescaler_ == 0) return true;
  if (connection(channel) != 1) return counting_.kind != avr::Counting::Kind::pwm;
  return 2 * kLowestTone_hz * prescaler_ * avr::period_of(counting_, pin_top_) > kClockHz;
}

/// Stores the present level of a channel. Call it before a change of the times or levels of the channel's
/// matches.
void Timer::keep_level(int channel, int64_t tick) {
  if (connection(channel) == 1 || counting_.kind != avr::Counting::Kind::pwm)
    toggled_[channel] = level_at(channel, tick);
  toggled_at_[channel] = tick;
}

/// Returns the tick at which the compare value that was written last takes effect.
int64_t Timer::held_until(int channel) const {
  if (replaced_at_[channel] < 0) return kLongAgo;
  const int64_t from = tick_at(replaced_at_[channel]) + 1;
  if (strays_ && counting_.dual_slope)
    return counting_.frequency_correct && !dual_slope_ && from == 1 ? 1 : kNoTick;
  return from + (taken_over_at() - from % period_ + period_) % period_;
}

void Timer::write_compare(int channel, uint16_t value) {
  set_compare(channel, value);
  if (connection(channel) < 2 || !is_held(channel)) return;
  late_ |= static_cast<uint8_t>(1 << channel);
  refresh_turn();
  if (turn_due_ < due_) due_ = turn_due_;
  if (turn_due_ < due_to_match_) due_to_match_ = turn_due_;
}

}  // namespace host
}  // namespace robosim
