#include "sim/mcu/avr/timer.h"

#include <algorithm>
#include <bit>

namespace robosim::avr {

Timer::Timer(Core& core, Pins& pins, Prescalers& prescalers, int index)
    : core_(core),
      pins_(pins),
      prescalers_(prescalers),
      spec_(core.chip.timers[index]),
      channels_(channels(spec_)),
      control_b_(spec_.control_b ? spec_.control_b : static_cast<Address>(spec_.control + 1)),
      prescaler_(spec_.own_prescaler ? Prescalers::kOwn : Prescalers::kShared) {
  hook_registers();
  for (const std::uint8_t flag :
       {Counter::kOverflow, Counter::kMatchA, Counter::kMatchB, Counter::kMatchC, Counter::kTop}) {
    if (!(flags_there_are() & flag)) continue;
    core.interrupts.on_entry<&Timer::entered>(vector_of(flag), this);
    core.triggers.offer<&Timer::awaited>(vector_of(flag), this);
  }
  for (int pin = 0; pin < core.chip.pin_count; ++pin) {
    const ChipPin& place = core.chip.pins[pin];
    if (place.timer == index) output_pins_[place.output] = pin;
    if (place.counted_by == index) pulse_listener_ = pins.add_listener<&Timer::pulsed>(pin, this);
    if (place.captured_by != index) continue;
    capture_listener_ = pins.add_listener<&Timer::captured>(pin, this);
    capture_pin_ = pin;
  }
  for (std::size_t channel = 0; channel < std::size(spec_.pins); ++channel)
    if (spec_.pins[channel]) output_pins_[channel] = pins.named(spec_.pins[channel]);
  for (const int pin : output_pins_)
    if (pin >= 0) pins.add_wave<&Timer::wave_level, &Timer::wave_heard>(pin, this);
  core.on_clock_change<&Timer::clock_changed>(this);
  due_ = core.events.add<&Timer::due>(this);
  prescalers.add(*this);
  core.keep(state_);
}

void Timer::reset(Cycle at) {
  state_ = {};
  state_.at = at;
  core_.events.cancel(due_);
  if (spec_.top) write_top(spec_.top, 0xFF);
  set_mode();
}

void Timer::clock_runs(bool runs, Cycle at) {
  if (runs) {
    state_.at = at;
  } else {
    count_to(at);
    state_.pulses = {};
    state_.captures = {};
  }
  state_.runs = runs;
  state_.drives_stale = true;
  settle();
}

bool Timer::awaited(int vector, bool awaited) {
  count_to(before_now());
  const std::uint8_t flag = flag_of(vector);
  state_.watched = static_cast<std::uint8_t>(awaited ? state_.watched | flag : state_.watched & ~flag);
  settle();
  return state_.flags & flag;
}

void Timer::clock_changed(std::int64_t) {
  if (spec_.top) set_mode();
  state_.drives_stale = true;
  settle();
}

void Timer::set_mode() {
  state_.counter.count(counting(spec_, control_a(), control_b()), is_wide() ? 0xFFFF : 0xFF, channels_);
  const auto divisor = static_cast<unsigned>(prescaler(spec_, control_b()));
  state_.shift = divisor ? std::max(std::countr_zero(divisor) - pll_shift(), 0) : -1;
  if (!is_external()) state_.pulses = {};
  state_.drives_stale = true;
  listen();
}

// Returns whether the prescaler provides ticks. A divisor of 1 bypasses the prescaler.
bool Timer::ticks_come() const {
  return state_.runs && state_.shift >= 0 && (state_.shift == 0 || !prescalers_.is_held(prescaler_));
}

void Timer::count_ticks(Cycle to) {
  if (to <= state_.at) return;
  if (ticks_come()) {
    const Cycle began = prescalers_.began(prescaler_);
    const Cycle ticks = ((to - began) >> state_.shift) - ((state_.at - began) >> state_.shift);
    if (ticks > 0 && state_.tones) toggle_tones(ticks);
    if (ticks > 0) set_flags(state_.counter.advance(ticks), to);
  }
  state_.at = to;
}

void Timer::count_to(Cycle to) {
  for (;;) {
    const Cycle edge = next_edge();
    if (edge > to || edge == kNoCycle) break;
    count_ticks(edge - 1);
    if (state_.captures.next() == edge) {
      state_.captures.take_first();
      state_.counter.set_capture(state_.counter.value());
      set_flags(kCaptured, edge);
    }
    if (state_.pulses.next() == edge) {
      state_.pulses.take_first();
      set_flags(state_.counter.advance(1), edge);
      state_.at = edge;
    }
  }
  count_ticks(to);
}

void Timer::set_flags(std::uint8_t hits, Cycle at) {
  for (std::size_t channel = 0; channel < channels_ && control_a() & kConnections; ++channel)
    if (hits & Counter::kMatch[channel] && changes_at_match(channel)) match(channel);
  if (hits & Counter::kTakenOver) state_.drives_stale = true;
  const auto fresh = static_cast<std::uint8_t>(hits & (kCounted | kCaptured) & ~state_.flags);
  state_.flags |= fresh;
  if (const auto started = static_cast<std::uint8_t>(fresh & state_.watched))
    core_.triggers.raised(vector_of(started), at + 1);
}

std::uint8_t Timer::flags_there_are() const {
  int flags = Counter::kOverflow | Counter::kMatchA | Counter::kMatchB;
  if (channels_ > 2) flags |= Counter::kMatchC;
  if (spec_.capture) flags |= kCaptured;
  return static_cast<std::uint8_t>(flags);
}

int Timer::vector_of(std::uint8_t flag) const {
  switch (flag) {
    case Counter::kMatchA:
      return spec_.vector;
    case Counter::kMatchB:
      return spec_.match_b_vector ? spec_.match_b_vector : spec_.vector + 1;
    case Counter::kMatchC:
      return spec_.vector + 2;
    case Counter::kOverflow:
      return spec_.overflow_vector ? spec_.overflow_vector : spec_.vector + channels_;
    default:
      return spec_.vector - 1;
  }
}

std::uint8_t Timer::flag_of(int vector) const {
  for (const std::uint8_t flag : {Counter::kOverflow, Counter::kMatchA, Counter::kMatchB, Counter::kMatchC})
    if (vector_of(flag) == vector) return flag;
  return kCaptured;
}

// Returns the flags that the clock edge at `at` will set. All earlier edges must have been counted.
std::uint8_t Timer::coming(Cycle at) const {
  std::uint8_t hits = next_edge() == at ? coming_by_edge() : std::uint8_t{0};
  if (ticks_come() && tick_after(state_.at, 1) == at) hits |= state_.counter.next_hits();
  return hits;
}

std::uint8_t Timer::coming_by_edge() const {
  const Cycle edge = next_edge();
  std::uint8_t hits = state_.captures.next() == edge ? kCaptured : std::uint8_t{0};
  if (state_.pulses.next() == edge) hits |= state_.counter.next_hits();
  return hits;
}

std::uint64_t Timer::may_interrupt() const {
  std::uint64_t vectors = 0;
  for (unsigned flags = enables() & flags_there_are(); flags; flags &= flags - 1)
    vectors |= Interrupts::bit(vector_of(static_cast<std::uint8_t>(flags & (0 - flags))));
  return vectors;
}

void Timer::request(unsigned flags) {
  state_.requested |= static_cast<std::uint8_t>(flags);
  for (; flags; flags &= flags - 1)
    core_.request(vector_of(static_cast<std::uint8_t>(flags & (0 - flags))), true);
}

// Requests an interrupt in the cycle of the edge that sets the interrupt's flag. Reads of registers return
// the new flag only in later cycles.
void Timer::due(Cycle at) {
  if (state_.beat && !state_.requested) return request(state_.beat);
  count_to(at - 1);
  request((state_.flags | coming(at)) & enables() & ~state_.requested);
  if (state_.drives_stale) tell_drives();
  if (state_.heard) tell_waves();
  schedule();
}

void Timer::entered(int vector) {
  if (state_.beat && beat()) return;
  count_to(core_.now());
  state_.flags &= static_cast<std::uint8_t>(~flag_of(vector));
  settle();
}

void Timer::settle() {
  for (unsigned gone = state_.requested & ~(state_.flags & enables()); gone; gone &= gone - 1)
    core_.request(vector_of(static_cast<std::uint8_t>(gone & (0 - gone))), false);
  state_.requested &= state_.flags & enables();
  request(state_.flags & enables() & ~state_.requested);
  if (state_.drives_stale) tell_drives();
  if (state_.heard) tell_waves();
  schedule();
}

// Returns the events that pins and ADC triggers need. Enabled interrupts may need further events.
std::uint8_t Timer::wanted() const {
  const Counter& counter = state_.counter;
  unsigned wanted = state_.watched & ~state_.flags & flags_of_ticks();
  if (!(control_a() & kConnections)) return static_cast<std::uint8_t>(wanted);
  for (std::size_t channel = 0; channel < channels_; ++channel) {
    if (!drives(channel)) continue;
    if (counter.waits()) wanted |= Counter::kTakenOver;
    if (is_followed(channel)) wanted |= Counter::kOverflow | Counter::kMatch[channel];
    const std::uint8_t com = connection(control_a(), static_cast<int>(channel));
    if (changes_at_match(channel) && (com == 1 || state_.outputs[channel].level != (com == 3)))
      wanted |= Counter::kMatch[channel];
  }
  return static_cast<std::uint8_t>(wanted);
}

// If the timer has only one enabled flag, which is set periodically (such as the overflow for millis()),
// predicts that flag. All other timers are counted normally.
void Timer::find_beat(std::uint8_t flag, Cycle at) {
  const Counter& counter = state_.counter;
  if (flag != enables() || !std::has_single_bit(flag) || at == kNoCycle || state_.requested ||
      state_.watched || control_a() & kConnections || next_edge() != kNoCycle || !counter.is_regular())
    return;
  state_.beat = flag;
  state_.beat_flags = flags_of_ticks() & flags_there_are();
  state_.beat_vector = vector_of(flag);
  state_.beat_at = at;
  state_.beat_period = (counter.top() + Cycle{1}) << state_.shift;
}

// Handles the entry of a predicted interrupt. Returns false if the timer must be counted instead: a whole
// period has passed, or another flag may have been set.
bool Timer::beat() {
  const Cycle now = core_.now(), next = state_.beat_at + state_.beat_period;
  if (next <= now || state_.beat_flags & ~(state_.flags | state_.beat)) return false;
  const Cycle began = prescalers_.began(prescaler_);
  state_.counter.pass(((now - began) >> state_.shift) - ((state_.at - began) >> state_.shift));
  state_.at = now;
  state_.flags &= static_cast<std::uint8_t>(~state_.beat);
  state_.requested = 0;
  core_.request(state_.beat_vector, false);
  state_.beat_at = next;
  core_.schedule(due_, next);
  return true;
}

Cycle Timer::tick_after(Cycle at, Cycle ticks) const {
  if (ticks == kNoCycle) return kNoCycle;
  const Cycle began = prescalers_.began(prescaler_);
  return began + ((((at - began) >> state_.shift) + ticks) << state_.shift);
}

Cycle Timer::when_due() {
  state_.beat = 0;
  const unsigned unseen = enables() & ~state_.flags & ~state_.requested;
  Cycle at = next_edge();
  if (at != kNoCycle && !(coming_by_edge() & unseen)) ++at;
  if (!ticks_come()) return at;
  const Counter& counter = state_.counter;
  if (const std::uint8_t flags = unseen & flags_of_ticks()) {
    at = std::min(at, tick_after(state_.at, counter.ticks_to(flags)));
    find_beat(flags, at);
  }
  if (const std::uint8_t hits = wanted()) {
    const Cycle tick = tick_after(state_.at, counter.ticks_to(hits));
    if (tick != kNoCycle) at = std::min(at, tick + 1);
  }
  return at;
}

void Timer::schedule() {
  const Cycle at = when_due();
  if (at == core_.events.due(due_)) return;
  if (at == kNoCycle) {
    core_.events.cancel(due_);
  } else {
    core_.schedule(due_, at);
  }
}

}  // namespace robosim::avr
