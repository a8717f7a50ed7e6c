#include "hal/host/timers.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

ROBOSIM_CLOCKWORK Timer timer0(0);
ROBOSIM_SETTINGS Timer timer1(1), timer2(2);
ROBOSIM_CLOCKWORK Timer0Count timer0_count;

namespace {
// The time between two overflows, in whole milliseconds and 125ths of a millisecond, as in the core's
// wiring.c. At 16 MHz, the time is 1024 us = 1 ms + 3/125 ms.
constexpr uint64_t kOverflow_us = 64 * 256 / (kClockHz / 1000000);
constexpr uint64_t kMillis = kOverflow_us / 1000, kFraction = kOverflow_us % 1000 / 8, kWhole = 125;

void count_overflows(uint64_t overflows) {
  timer0_count.overflows += overflows;
  timer0_count.fraction += kFraction * overflows;
  timer0_count.millis += kMillis * overflows + timer0_count.fraction / kWhole;
  timer0_count.fraction %= kWhole;
}
}  // namespace

void timer0_catch_up() {
  if (!interrupts_enabled() || !(timer0.enabled() & Timer::overflow)) return;
  count_overflows(static_cast<uint64_t>(timer0.take_overflows()));
}

int64_t Timer::tick_at(SimTime at) const {
  if (prescaler_ == 0) return base_tick_;
  return base_tick_ + kCycles.whole(at - base_, prescaler_);
}

SimTime Timer::time_of(int64_t tick) const {
  return base_ + kCycles.at_least((tick - base_tick_) * prescaler_);
}

SimTime Timer::ticks_from_now(int64_t count) const { return time_of(ticks() + count); }

uint16_t Timer::count() const { return count_at(ticks()); }

uint16_t Timer::count_at(int64_t tick) const {
  if (__builtin_expect(tick < hidden_, 0)) return set_to_;
  const int64_t at = tick % period_;
  return static_cast<uint16_t>(dual_slope_ && at > top_ ? period_ - at : at);
}

void Timer::take_registers(const Phase& phase) {
  prescaler_ = avr::prescaler(kChip.timers[number_], control_b_);
  counting_ = avr::counting(kChip.timers[number_], control_a_, control_b_);
  base_ = phase.prescaler == prescaler_ ? phase.tick_began : state.now;
  begin(phase.count, phase.down, phase.hidden);
  refresh_due(base_tick_);
  refresh_timer_pins(number_);
  refresh_waves();
}

void Timer::tell_of_mode(bool made_pwm, uint8_t control_a) const {
  if (made_pwm == makes_pwm()) return;
  const int connected = (avr::connection(control_a, 0) >> 1) | (avr::connection(control_a, 1) & 2);
  executor->acted({FirmwareAction::Kind::timer_mode, {kChip.timers[number_].number, makes_pwm(), connected}});
}

void Timer::set_control_a(uint8_t value) {
  const Phase phase = leave_registers();
  const bool captured = captures_edges(), made_pwm = makes_pwm();
  const uint8_t before = control_a_;
  control_a_ = value;
  take_registers(phase);
  tell_of_mode(made_pwm, before);
  if (captured != captures_edges()) refresh_external();
}

void Timer::set_control_b(uint8_t value) {
  const Phase phase = leave_registers();
  const bool counted = counts_edges(), captured = captures_edges(), made_pwm = makes_pwm();
  const uint8_t before = control_b_;
  control_b_ = value;
  take_registers(phase);
  tell_of_mode(made_pwm, control_a_);
  if (value & (kIcnc | kIces)) listen_to_captures();
  if (counted != counts_edges() || captured != captures_edges()) refresh_external();
  if (value & ~before & kIcnc) begin_canceler();
}

void Timer::set_connection(int channel, uint8_t bits) {
  const uint8_t before = connection(channel);
  if (bits == before) return;
  sync_waves();
  if (bits == 1 || before == 1 || counting_.kind != avr::Counting::Kind::pwm) keep_level(channel, ticks());
  const int shift = channel == 0 ? 6 : 4;
  control_a_ = static_cast<uint8_t>((control_a_ & ~(3 << shift)) | bits << shift);
}

void Timer::set_compare(int channel, uint16_t value) {
  const uint8_t flag = channel == 0 ? compare_a : compare_b;
  const bool interrupts = enabled_ & flag, pwm = makes_pwm();
  if (value == compare_[channel]) return;
  if (!pwm && connection(channel) & 2)
    executor->acted({FirmwareAction::Kind::compare_write, {kChip.timers[number_].number, channel, 0}});
  if (!pwm && (is_top(channel) || interrupts)) {
    const Phase phase = leave_registers();
    compare_[channel] = value;
    return take_registers(phase);
  }
  sync_waves();
  sync();
  if (!(flags_ & flag)) sync_disabled();
  if (!pwm) {
    keep_level(channel, ticks());
  } else if (!is_held(channel)) {
    held_[channel] = compare_[channel];
    replaced_at_[channel] = state.now;
  }
  compare_[channel] = value;
  if (is_top(channel)) turn_where_taken_over();
  if (is_top(channel) || interrupts) refresh_due(ticks());
  refresh_waves();
}

bool Timer::level_at(int channel, int64_t tick) const {
  const uint8_t connected = connection(channel);
  const int64_t until = held_until(channel);
  if (connected == 1 || counting_.kind != avr::Counting::Kind::pwm) {
    const int64_t from = toggled_at_[channel] < hidden_ ? hidden_ : toggled_at_[channel];
    if (!drives(channel) || tick <= from) return toggled_[channel];
    int64_t at[2] = {0, 0};
    const int count = matches(tick <= until ? held_[channel] : compare_[channel], at);
    int64_t matched = 0;
    for (int i = 0; i < count; ++i)
      matched += (tick - at[i] + period_) / period_ - (from - at[i] + period_) / period_;
    return connected == 1 ? toggled_[channel] != (matched % 2 != 0)
           : matched      ? connected == 3
                          : toggled_[channel];
  }
  const uint16_t compare = tick < until ? held_[channel] : compare_[channel];
  if (__builtin_expect(strays_, 0)) {
    const bool low = counting_.dual_slope && compare == 0;
    const uint16_t count = count_at(tick);
    const bool high = !low && (compare >= pin_top_ || count < compare || (count == compare && !dual_slope_));
    return high != (connected == 3);
  }
  return avr::pwm_level(counting_, top_, compare, connected, tick % period_);
}

/// Returns the first tick after `after` at which PWM with the value `compare` changes its level. Returns
/// INT64_MAX if the level never changes.
int64_t Timer::next_change(uint16_t compare, int64_t after) const {
  if (compare >= pin_top_ || (counting_.dual_slope && compare == 0)) return INT64_MAX;
  const int64_t falls = compare + 1, rises = dual_slope_ ? (2 * top_ - compare + 1) % period_ : 0;
  const int64_t from = (after + 1) % period_;
  const int64_t to_fall = (falls - from + period_) % period_, to_rise = (rises - from + period_) % period_;
  return after + 1 + (to_fall < to_rise ? to_fall : to_rise);
}

SimTime Timer::next_edge(int channel, SimTime after) const {
  if (prescaler_ == 0) return kNever;
  const int64_t tick = tick_at(after), until = held_until(channel);
  SimTime edge = kNever;
  if (connection(channel) == 1) {
    edge = next(channel + 1, tick);
  } else {
    int64_t change = next_change(tick < until ? held_[channel] : compare_[channel], tick);
    if (tick < until && change >= until)
      change =
          level_at(channel, until) != level_at(channel, tick) ? until : next_change(compare_[channel], until);
    if (change != INT64_MAX) edge = time_of(change);
  }
  return edge < turns_at_ || after >= turns_at_ ? edge : turns_at_;
}

void Timer::count_edge(bool level) {
  if (!counts_edges() || level != (control_b_ & 1)) return;  // CS: 6 falling, 7 rising edges
  overflows_seen_ = disabled_seen_ = ++base_tick_;
  const int64_t now = base_tick_ % period_;
  for (int flag = 0; flag < flag_count_; ++flag) {
    const bool match = flag == 1 || flag == 2;
    int64_t at[2] = {0, 0};
    const int count = match && replaced_at_[flag - 1] >= 0 ? matches(held_[flag - 1], at) : raises(flag, at);
    for (int i = 0; i < count; ++i)
      if (at[i] == now && !(match && base_tick_ == hidden_)) flags_ |= bit_of(flag);
  }
  if (now == taken_over_at() && !(strays_ && counting_.dual_slope))
    for (SimTime& time : replaced_at_) time = -1;
  if (base_tick_ == turn_) turn();
  if (turn_due_ <= state.now) take_turns();
  if (control_a_ & kConnections) refresh_timer_pins(number_);
}

void Timer::set_capture(uint16_t value) {
  if (counting_.top != avr::Counting::Top::capture) return;  // ICRn is writable only as TOP (16.6)
  const Phase phase = leave_registers();
  capture_ = value;
  take_registers(phase);
}

void Timer::set_count(uint16_t value) {
  const Phase phase = leave_registers();
  base_ = phase.tick_began;
  set_to_ = value;
  begin(value, phase.down, true);
  refresh_due(base_tick_);
  refresh_waves();
}

void Timer::reset_prescaler() {
  Phase phase = leave_registers();
  phase.tick_began = state.now;
  take_registers(phase);
}

void Timer::force_compare(uint8_t bits) {
  if (makes_pwm()) return;
  const Phase phase = leave_registers();
  for (int channel = 0; channel < 2; ++channel) {
    const uint8_t com = connection(channel);
    if (com && bits << channel & kFoca) toggled_[channel] = com == 1 ? !toggled_[channel] : com == 3;
  }
  take_registers(phase);
}

void Timer::set_enabled(uint8_t mask) {
  sync();
  sync_disabled();
  enabled_ = mask & (overflow | compare_a | compare_b | (has_capture() ? captured : 0));
  if (enabled_ & captured) listen_to_captures();
  refresh_due(ticks());
}

void Timer::clear_flags(uint8_t mask) {
  sync();
  sync_disabled();
  if (mask & captured) listen_to_captures();
  flags_ &= static_cast<uint8_t>(~mask);
}

void Timer::leave_bottom() {
  if (compare_[0] == 0) flags_ |= compare_a;
  if (compare_[1] == 0) flags_ |= compare_b;
  disabled_seen_ = base_tick_ + 1;
}

uint8_t Timer::flags() {
  sync();
  sync_disabled();
  listen_to_captures();
  return flags_;
}

int Timer::matches(int64_t value, int64_t (&at)[2]) const {
  if (value > top_) return 0;
  at[0] = (value + 1) % period_;  // the flag follows one tick after the match
  if (!dual_slope_) return 1;
  at[1] = (2 * top_ - value + 1) % period_;
  return at[0] == at[1] ? 1 : 2;
}

int Timer::raises(int flag, int64_t (&at)[2]) const {
  if (flag == 1 || flag == 2) return matches(compare_[flag - 1], at);
  at[0] = flag == 0 ? overflows_at() : dual_slope_ ? (top_ + 1) % period_ : 0;
  return flag == 0 ? overflows() : counting_.top == avr::Counting::Top::capture && !strays_;
}

bool Timer::passed(int64_t at, int64_t from, int64_t until) const {
  return (until - at + period_) / period_ > (from - at + period_) / period_;
}

bool Timer::raised(int flag, int64_t until) const {
  int64_t at[2];
  if (flag != 1 && flag != 2) return raises(flag, at) && passed(at[0], disabled_seen_, until);
  const int channel = flag - 1;
  int64_t from = disabled_seen_ < hidden_ ? hidden_ : disabled_seen_;
  const int64_t held = held_until(channel);
  if (from < held) {
    const int64_t to = until < held ? until : held;
    for (int i = matches(held_[channel], at); i-- > 0;)
      if (passed(at[i], from, to)) return true;
    from = held;
  }
  for (int i = from < until ? matches(compare_[channel], at) : 0; i-- > 0;)
    if (passed(at[i], from, until)) return true;
  return false;
}

void Timer::sync_disabled(int64_t until) {
  if (until < disabled_seen_) return;
  for (int flag = 0; flag < flag_count_; ++flag)
    if (!((enabled_ | flags_) & bit_of(flag)) && raised(flag, until)) flags_ |= bit_of(flag);
  disabled_seen_ = until;
}

int64_t Timer::first(int64_t at, int64_t after) const {
  return after + 1 + (at - (after + 1) % period_ + period_) % period_;
}

SimTime Timer::next(int flag, int64_t after) const {
  if (flag == 1 || flag == 2) return next_match(flag - 1, after);
  int64_t at[2];
  return raises(flag, at) ? time_of(first(at[0], after)) : kNever;
}

SimTime Timer::next_match(int channel, int64_t after) const {
  const auto next = [&](uint16_t value) {
    int64_t at[2], next = kNoTick;
    for (int i = matches(value, at); i-- > 0;) {
      const int64_t tick = first(at[i], after);
      if (tick < next) next = tick;
    }
    return next;
  };
  if (after < hidden_) after = hidden_;
  int64_t tick = kNoTick;
  const int64_t held = held_until(channel);
  if (after < held) {
    tick = next(held_[channel]);
    if (tick > held) after = held;
  }
  if (after >= held) tick = next(compare_[channel]);
  return tick == kNoTick ? kNever : time_of(tick);
}

void Timer::refresh_due(int64_t after) {
  turns_at_ = turn_due_ = kNever;
  if (__builtin_expect(turn_ != kNoTick || late_ || pins_stale_ || steps(), 0)) refresh_turn();
  due_of_[0] = prescaler_ != 0 && enabled_ & overflow ? next(0, after) : kNever;
  due_ = due_to_match_ = turn_due_;
  for (int flag = 1; flag < 4; ++flag) {
    if (__builtin_expect(!(enabled_ & ~overflow) || prescaler_ == 0 || !(enabled_ & bit_of(flag)), 1)) {
      due_of_[flag] = kNever;
      continue;
    }
    due_of_[flag] = next(flag, after);
    if (due_of_[flag] < due_to_match_) due_ = due_to_match_ = due_of_[flag];
  }
  if (due_of_[0] < due_) due_ = due_of_[0];
}

void Timer::raise_due() {
  if (state.now >= turn_due_) take_turns();
  for (int flag = 0; flag < flag_count_; ++flag)
    if (state.now >= due_of_[flag]) flags_ |= bit_of(flag);
  if (flags_ & overflow && enabled_ & overflow) overflows_seen_ = ticks();
  refresh_due(ticks());
}

int64_t Timer::take_overflows() {
  if (state.now < due_of_[0]) return 0;
  const int64_t until = ticks();
  int64_t count = 0;
  if (__builtin_expect(counts_bytes() && until >= 0, 1)) {
    count = until / 256 - overflows_seen_ / 256;
    due_of_[0] = time_of((until / 256 + 1) * 256);
  } else {
    const int64_t ahead = period_ - overflows_at();
    count = (until + ahead) / period_ - (overflows_seen_ + ahead) / period_;
    due_of_[0] = next(0, until);
  }
  overflows_seen_ = until;
  due_ = due_of_[0] < due_to_match_ ? due_of_[0] : due_to_match_;
  return count;
}

bool Timer::drives(int channel) const { return avr::drives_pin(counting_, connection(channel), channel); }

PinDrive Timer::drive(int channel) const {
  if (prescaler_ == 0 || (steps() && steps(channel))) return PinDrive::constant(level_at(channel, ticks()));
  const bool late = late_ >> channel & 1 || is_top(channel);
  const uint16_t compare = late && is_held(channel) ? held_[channel] : compare_[channel];
  return avr::timer_drive(counting_, prescaler_, pin_top_, compare, connection(channel), kClockHz);
}

}  // namespace host
}  // namespace robosim

// Defines Timer 0's overflow handler, which does the same as the core's (wiring.c).
static_assert(robosim::host::kTimer0Overflow == 16, "the handler's name");
extern "C" void __vector_16() {
  robosim::host::state.now += robosim::host::kOverflowTakes;
  robosim::host::count_overflows(1);
}
