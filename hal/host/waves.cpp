#include "hal/host/waves.h"

#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/tone.h"

namespace robosim {
namespace host {

ROBOSIM_CLOCKWORK SimTime wave_due = kNever;
PinSet followed;

namespace {

ROBOSIM_CLOCKWORK SimTime next_edges[kPins];  // valid for followed pins

bool level_at(Pin pin, SimTime at) {
  const TimerPin by = timer_of(pin);
  return is_timed(pin) ? timer(by.timer).level(by.channel, at) : tone_level(at);
}

SimTime next_edge(Pin pin, SimTime after) {
  const TimerPin by = timer_of(pin);
  return is_timed(pin) ? timer(by.timer).next_edge(by.channel, after) : next_tone_edge(after);
}

template <typename Do>
void for_each_followed(Do what) {
  wave_due = kNever;
  for (Pin pin = 0; pin < kPins; ++pin) {
    if (!followed.has(pin)) continue;
    what(pin);
    if (next_edges[pin] < wave_due) wave_due = next_edges[pin];
  }
}

}  // namespace

bool wave_level(Pin pin) { return level_at(pin, state.now); }

SimTime wave_until(Pin pin) { return next_edge(pin, state.now); }

namespace {

void tell_until(SimTime limit) {
  for_each_followed([limit](Pin pin) {
    SimTime& next = next_edges[pin];
    // A timer must receive every edge. Interrupt flags depend only on the first two edges and on the last
    // level.
    const bool timed = places[pin].counted_by >= 0 || places[pin].captured_by >= 0;
    for (int told = 0; (timed || told < 2) && next <= limit; ++told) {
      hear_level(pin, level_at(pin, next), next);
      next = next_edge(pin, next);
    }
    if (next > limit) return;
    hear_level(pin, level_at(pin, limit), limit);
    next = next_edge(pin, limit);
  });
}

SimTime next_turn() {
  const SimTime a = timer0.turns_at(), b = timer1.turns_at(), c = timer2.turns_at();
  return a < b && a < c ? a : b < c ? b : c;
}

}  // namespace

void tell_waves() {
  for (SimTime turn = next_turn(); turn <= state.now; turn = next_turn()) {
    tell_until(turn);
    for (int number = 0; number < 3; ++number)
      if (timer(number).turns_at() == turn) timer(number).turn();
    for_each_followed([turn](Pin pin) { next_edges[pin] = next_edge(pin, turn); });
  }
  tell_until(state.now);
}

void follow_anew() {
  for_each_followed([](Pin pin) {
    hear_level(pin, wave_level(pin), state.now);
    next_edges[pin] = wave_until(pin);
  });
}

void refresh_wave(Pin pin) {
  if (heard.has(pin) && is_wave(pin)) {
    followed.add(pin);
    next_edges[pin] = wave_until(pin);
  } else {
    followed.remove(pin);
  }
  for_each_followed([](Pin) {});
}

}  // namespace host
}  // namespace robosim
