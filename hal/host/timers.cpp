#include "hal/host/timers.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

ROBOSIM_CLOCKWORK Timer timer0(0);
Timer timer1(1), timer2(2);
ROBOSIM_CLOCKWORK Timer0Count timer0_count;

namespace {
// As in the core's wiring.c: what an overflow takes, in whole milliseconds and 125ths of one. At 16 MHz that
// is 1024 us = 1 ms + 3/125 ms.
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

int64_t Timer::position() const { return ticks() % period_; }

uint16_t Timer::count() const { return count_at(ticks()); }

uint16_t Timer::count_at(int64_t tick) const {
  const int64_t at = tick % period_;
  return static_cast<uint16_t>(counting_.dual_slope && at > top_ ? period_ - at : at);
}

void Timer::decode() {
  prescaler_ = avr::prescaler(kChip.timers[number_], control_b_);
  counting_ = avr::counting(kChip.timers[number_], control_a_, control_b_);
  top_ = avr::top_of(counting_, compare_[0], capture_);
  period_ = avr::period_of(counting_, top_);
  lasts_ = kCycles.at_least(period_ * prescaler_);
}

Timer::Phase Timer::leave_registers() {
  if (captures_edges()) hear();
  sync_waves();
  sync();
  sync_disabled();
  for (int channel = 0; channel < 2; ++channel) keep_level(channel);
  return {position(), prescaler_, prescaler_ == 0 ? state.now : time_of(ticks())};
}

void Timer::take_registers(const Phase& phase) {
  decode();
  base_ = phase.prescaler == prescaler_ ? phase.tick_began : state.now;
  base_tick_ = overflows_seen_ = disabled_seen_ = phase.position % period_;
  forget_levels();
  refresh_due();
  refresh_timer_pins(number_);
  refresh_waves();
}

void Timer::set_control_a(uint8_t value) {
  const Phase phase = leave_registers();
  const bool captured = captures_edges();
  control_a_ = value;
  take_registers(phase);
  if (captured != captures_edges()) refresh_external();
}

void Timer::set_control_b(uint8_t value) {
  const Phase phase = leave_registers();
  const bool counted = counts_edges(), captured = captures_edges();
  const uint8_t before = control_b_;
  control_b_ = value;
  take_registers(phase);
  if (value & (kCanceler | kRisingCapture)) listen_to_captures();
  if (counted != counts_edges() || captured != captures_edges()) refresh_external();
  if (value & ~before & kCanceler) begin_canceler();
}

void Timer::set_connection(int channel, uint8_t bits) {
  const uint8_t before = connection(channel);
  if (bits == before) return;
  sync_waves();
  if (bits == 1 || before == 1) keep_level(channel);
  const int shift = channel == 0 ? 6 : 4;
  control_a_ = static_cast<uint8_t>((control_a_ & ~(3 << shift)) | bits << shift);
}

void Timer::set_compare(int channel, uint16_t value) {
  const bool is_top = channel == 0 && counting_.top == avr::Counting::Top::compare_a;
  const uint8_t flag = channel == 0 ? compare_a : compare_b;
  const bool interrupts = enabled_ & flag;
  if (value == compare_[channel]) return;
  if (is_top || interrupts) {
    const Phase phase = leave_registers();
    compare_[channel] = value;
    return take_registers(phase);
  }
  sync_waves();
  if (!(flags_ & flag)) sync_disabled();
  if (counting_.kind == avr::Counting::Kind::pwm) {
    hold(channel);
  } else {
    keep_level(channel);
  }
  compare_[channel] = value;
  refresh_waves();
}

/// When the count of ticks has been set anew: toggled pins stay as keep_level() has left them.
void Timer::forget_levels() {
  for (int64_t& tick : toggled_at_) tick = base_tick_;
  for (SimTime& time : replaced_at_) time = -1;
}

/// Before something changes that tells when the channel toggles its pin.
void Timer::keep_level(int channel) {
  const int64_t now = ticks();
  if (connection(channel) == 1) toggled_[channel] = level_at(channel, now);
  toggled_at_[channel] = now;
}

/// Before the register of a channel with PWM is written.
void Timer::hold(int channel) {
  if (prescaler_ == 0) return;
  if (state.now - replaced_at_[channel] < lasts_ && ticks() < held_until(channel)) return;
  held_[channel] = compare_[channel];
  replaced_at_[channel] = state.now;
}

/// The tick until which the value holds that was replaced.
int64_t Timer::held_until(int channel) const {
  if (replaced_at_[channel] < 0) return 0;
  const int64_t from = tick_at(replaced_at_[channel]) + 1;
  const int64_t at = counting_.dual_slope && !counting_.frequency_correct ? top_ : 0;
  return from + (at - from % period_ + period_) % period_;
}

bool Timer::level_at(int channel, int64_t tick) const {
  const uint8_t connected = connection(channel);
  if (connected == 1) {
    int64_t at[2] = {0, 0};
    const int count = matches(channel, at);
    int64_t toggles = 0;
    for (int i = 0; i < count; ++i)
      toggles += (tick - at[i] + period_) / period_ - (toggled_at_[channel] - at[i] + period_) / period_;
    return toggled_[channel] != (toggles % 2 != 0);
  }
  const uint16_t compare = tick < held_until(channel) ? held_[channel] : compare_[channel];
  return avr::pwm_level(counting_, top_, compare, connected, tick % period_);
}

/// The first tick behind `after` at which PWM of that value changes its level; INT64_MAX if there is none.
int64_t Timer::next_change(uint16_t compare, int64_t after) const {
  if (compare >= top_ || (counting_.dual_slope && compare == 0)) return INT64_MAX;
  const int64_t falls = compare + 1, rises = counting_.dual_slope ? (2 * top_ - compare + 1) % period_ : 0;
  const int64_t from = (after + 1) % period_;
  const int64_t to_fall = (falls - from + period_) % period_, to_rise = (rises - from + period_) % period_;
  return after + 1 + (to_fall < to_rise ? to_fall : to_rise);
}

SimTime Timer::next_edge(int channel, SimTime after) const {
  if (prescaler_ == 0) return kNever;
  const int64_t tick = tick_at(after), until = held_until(channel);
  if (connection(channel) == 1) return next(channel + 1, tick);
  int64_t change = next_change(tick < until ? held_[channel] : compare_[channel], tick);
  if (tick < until && change >= until)
    change =
        level_at(channel, until) != level_at(channel, tick) ? until : next_change(compare_[channel], until);
  return change == INT64_MAX ? kNever : time_of(change);
}

void Timer::count_edge(bool level) {
  if (!counts_edges() || level != (control_b_ & 1)) return;  // CS: 6 falling, 7 rising
  overflows_seen_ = disabled_seen_ = ++base_tick_;
  const int64_t now = position();
  for (int flag = 0, there_are = flags_there_are(); flag < there_are; ++flag) {
    int64_t at[2] = {0, 0};
    const int count = raises(flag, at);
    for (int i = 0; i < count; ++i)
      if (at[i] == now) flags_ |= bit_of(flag);
  }
}

void Timer::set_capture(uint16_t value) {
  if (counting_.top != avr::Counting::Top::capture) return;  // 16.6: only then it can be written
  const Phase phase = leave_registers();
  capture_ = value;
  take_registers(phase);
}

void Timer::set_count(uint16_t value) {
  if (captures_edges()) hear();
  sync_waves();
  sync();
  sync_disabled();
  for (int channel = 0; channel < 2; ++channel) keep_level(channel);
  base_ = state.now;
  base_tick_ = overflows_seen_ = disabled_seen_ = value % period_;
  forget_levels();
  refresh_due();
  refresh_waves();
}

void Timer::set_enabled(uint8_t mask) {
  sync();
  sync_disabled();
  enabled_ = mask & (overflow | compare_a | compare_b | (has_capture() ? captured : 0));
  if (enabled_ & captured) listen_to_captures();
  refresh_due();
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

int Timer::matches(int channel, int64_t (&at)[2]) const {
  const int64_t value = compare_[channel];
  if (value > top_) return 0;
  at[0] = (value + 1) % period_;  // the flag follows one tick after the match
  if (!counting_.dual_slope) return 1;
  at[1] = (2 * top_ - value + 1) % period_;
  return at[0] == at[1] ? 1 : 2;
}

int Timer::raises(int flag, int64_t (&at)[2]) const {
  if (flag == 1 || flag == 2) return matches(flag - 1, at);
  at[0] = flag == 0 ? overflows_at() : counting_.dual_slope ? (top_ + 1) % period_ : 0;
  return flag == 0 ? overflows() : counting_.top == avr::Counting::Top::capture;
}

bool Timer::passed(int64_t event, int64_t until) const {
  return (until - event + period_) / period_ > (disabled_seen_ - event + period_) / period_;
}

void Timer::sync_disabled() {
  if (prescaler_ == 0) return;
  const int64_t until = ticks();
  if (until < disabled_seen_) return;
  for (int flag = 0, there_are = flags_there_are(); flag < there_are; ++flag) {
    if ((enabled_ | flags_) & bit_of(flag)) continue;
    int64_t at[2] = {0, 0};
    const int count = raises(flag, at);
    for (int i = 0; i < count; ++i)
      if (passed(at[i], until)) flags_ |= bit_of(flag);
  }
  disabled_seen_ = until;
}

SimTime Timer::next(int flag, int64_t after) const {
  int64_t at[2] = {0, 0};
  const int count = raises(flag, at);
  int64_t first = INT64_MAX;
  for (int i = 0; i < count; ++i) {
    const int64_t tick = after + 1 + (at[i] - (after + 1) % period_ + period_) % period_;
    if (tick < first) first = tick;
  }
  return first == INT64_MAX ? kNever : time_of(first);
}

void Timer::refresh_due() {
  due_ = kNever;
  for (int flag = 0, there_are = flags_there_are(); flag < there_are; ++flag) {
    due_of_[flag] = prescaler_ != 0 && enabled_ & bit_of(flag) ? next(flag, ticks()) : kNever;
    if (due_of_[flag] < due_) due_ = due_of_[flag];
  }
}

void Timer::raise_due() {
  for (int flag = 0, there_are = flags_there_are(); flag < there_are; ++flag)
    if (state.now >= due_of_[flag]) flags_ |= bit_of(flag);
  if (flags_ & overflow && enabled_ & overflow) overflows_seen_ = ticks();
  refresh_due();
}

int64_t Timer::take_overflows() {
  if (state.now < due_of_[0]) return 0;
  const int64_t until = ticks();
  const int64_t ahead = period_ - overflows_at();
  const int64_t count = (until + ahead) / period_ - (overflows_seen_ + ahead) / period_;
  overflows_seen_ = until;
  due_of_[0] = next(0, until);
  due_ = due_of_[0] < due_to_match() ? due_of_[0] : due_to_match();
  return count;
}

bool Timer::drives(int channel) const { return avr::drives_pin(counting_, connection(channel), channel); }

PinDrive Timer::drive(int channel) const {
  return avr::timer_drive(counting_, prescaler_, top_, compare_[channel], connection(channel), kClockHz);
}

}  // namespace host
}  // namespace robosim

/// The core's handler of Timer 0's overflow (wiring.c).
static_assert(robosim::host::kTimer0Overflow == 16, "the handler's name");
extern "C" void __vector_16() {
  robosim::host::state.now += robosim::host::cycles(robosim::host::cost::kTimer0Overflow);
  robosim::host::count_overflows(1);
}
