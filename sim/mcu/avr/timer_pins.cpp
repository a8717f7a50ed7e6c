// Implements the pins of a timer: outputs (DS40002061B, 15.6, 16.8, 18.6) and inputs (16.6, 17.2).
#include <algorithm>

#include "sim/mcu/avr/timer.h"

namespace robosim::avr {
namespace {

constexpr std::int64_t kLowestTone_hz = 20;
constexpr std::uint8_t kRisingClock = 7;

}  // namespace

bool Timer::drives(std::size_t channel) const {
  const auto number = static_cast<int>(channel);
  return output_pins_[channel] >= 0 &&
         drives_pin(state_.counter.how(), connection(control_a(), number), number);
}

void Timer::match(std::size_t channel) {
  bool& level = state_.outputs[channel].level;
  const std::uint8_t com = connection(control_a(), static_cast<int>(channel));
  const bool then = com == 1 ? !level : com == 2 ? false : com == 3 ? true : level;
  if (then != level) state_.drives_stale = true;
  level = then;
}

void Timer::force(std::uint8_t control) {
  if (state_.counter.how().kind == Counting::Kind::pwm) return;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    if (control & kFoca >> channel) match(channel);
}

// Returns whether the level of a pin is reported at each match.
bool Timer::changes_at_match(std::size_t channel) const {
  const Counter& counter = state_.counter;
  if (!drives(channel)) return false;
  if (connection(control_a(), static_cast<int>(channel)) != 1)
    return counter.how().kind != Counting::Kind::pwm;
  if (counter.compare(channel) > counter.top()) return true;
  const std::int64_t period = period_of(counter.how(), counter.top()) << std::max(state_.shift, 0);
  return is_external() || 2 * kLowestTone_hz * period > core_.clock_hz;
}

// Returns the current level of a pin with PWM. The pin keeps this level when the clock stops.
bool Timer::pwm_level(std::size_t channel) const {
  const Counter& counter = state_.counter;
  const std::uint16_t compare = counter.compare(channel), value = counter.value();
  bool high = compare >= counter.top() || value < compare ||
              (value == compare && !counter.counts_down() && !counter.how().short_pulse);
  if ((counter.how().dual_slope || counter.how().short_pulse) && compare == 0) high = false;
  return high != (connection(control_a(), static_cast<int>(channel)) == 3);
}

PinDrive Timer::drive_of(std::size_t channel) const {
  const Counter& counter = state_.counter;
  const std::uint8_t com = connection(control_a(), static_cast<int>(channel));
  const bool pwm = counter.how().kind == Counting::Kind::pwm && com != 1;
  const bool counts = ticks_come() || (state_.runs && is_external());
  const bool toggles = com == 1 && ticks_come() && !changes_at_match(channel);
  if ((pwm && counts) || toggles)
    return timer_drive(counter.how(), 1 << std::max(state_.shift, 0), counter.top(), counter.compare(channel),
                       com, core_.clock_hz);
  return PinDrive::constant(pwm ? pwm_level(channel) : state_.outputs[channel].level);
}

std::size_t Timer::channel_of(int pin) const {
  return static_cast<std::size_t>(std::find(output_pins_.begin(), output_pins_.end(), pin) -
                                  output_pins_.begin());
}

// Returns the level of a pin that is reported as PWM or as a tone.
bool Timer::level_of(std::size_t channel) const {
  return state_.tones >> channel & 1 ? state_.outputs[channel].level : pwm_level(channel);
}

bool Timer::wave_level(int pin) {
  count_to(before_now());
  return level_of(channel_of(pin));
}

void Timer::wave_heard(int pin, bool heard) {
  const auto bit = static_cast<std::uint8_t>(1u << channel_of(pin));
  count_to(before_now());
  state_.heard = static_cast<std::uint8_t>(heard ? state_.heard | bit : state_.heard & ~bit);
  settle();
}

bool Timer::is_followed(std::size_t channel) const {
  const Output& output = state_.outputs[channel];
  return state_.heard >> channel & 1 && output.taken && output.drive.pwm;
}

void Timer::toggle_tones(Cycle ticks) {
  for (std::size_t channel = 0; channel < channels_; ++channel)
    if (state_.tones >> channel & 1 && state_.counter.matches(channel, ticks) % 2 == 1)
      state_.outputs[channel].level = !state_.outputs[channel].level;
}

void Timer::tell_waves() {
  for (std::size_t channel = 0; channel < channels_; ++channel)
    if (is_followed(channel)) pins_.wave_edge(output_pins_[channel], level_of(channel));
}

void Timer::tell_drives() {
  state_.drives_stale = false;
  state_.tones = 0;
  for (std::size_t channel = 0; channel < channels_; ++channel) {
    Output& output = state_.outputs[channel];
    if (!drives(channel)) {
      if (output.taken) pins_.give_back(output_pins_[channel]);
      output.taken = false;
      continue;
    }
    const PinDrive drive = drive_of(channel);
    if (drive.tone_hz > 0) state_.tones |= static_cast<std::uint8_t>(1u << channel);
    if (output.taken && drive == output.drive) continue;
    output.taken = true;
    output.drive = drive;
    pins_.take(output_pins_[channel], drive);
  }
}

void Timer::listen() {
  if (pulse_listener_ >= 0) pins_.listen(pulse_listener_, is_external());
  if (capture_listener_ >= 0)
    pins_.listen(capture_listener_, state_.wants_captures && is_captured() && !state_.captures_comparator);
}

void Timer::want_captures() {
  if (state_.wants_captures || capture_listener_ < 0) return;
  state_.wants_captures = true;
  listen();
}

void Timer::pulsed(int, bool level, Cycle at) {
  if (!state_.runs || level != ((control_b() & kCs) == kRisingClock)) return;
  state_.pulses.add(std::max(at + kEdgeCycles, state_.at + 1));
  schedule();
}

// Selects the source of captures. A change of the source counts as an edge if the sources' levels differ
// (16.6.1).
void Timer::capture_comparator(bool is, bool level, Cycle at) {
  if (is == state_.captures_comparator) return;
  const bool before = capture_level();
  state_.captures_comparator = is;
  state_.comparator = level;
  state_.wants_captures = true;
  listen();
  if (is_captured() && capture_level() != before) capture_edge(!before, at);
}

void Timer::comparator_changed(bool level, Cycle at) {
  if (!state_.captures_comparator) return;
  state_.comparator = level;
  if (is_captured()) capture_edge(level, at);
}

void Timer::captured(int, bool level, Cycle at) { capture_edge(level, at); }

void Timer::capture_edge(bool level, Cycle at) {
  if (!state_.runs) return;
  const bool rising = control_b() & kIces, cancels = control_b() & kIcnc;
  if (cancels && state_.canceler.change(level, at) == NoiseCanceler::Verdict::takes_back) {
    if (level != rising && state_.captures.any()) state_.captures.take_last();
  } else if (level == rising) {
    state_.captures.add(std::max(at + kEdgeCycles + (cancels ? kCancelerCycles : 0), state_.at + 1));
  }
  schedule();
}

}  // namespace robosim::avr
