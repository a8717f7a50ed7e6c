#include "hal/host/polling.h"

#include "hal/host/adc.h"
#include "hal/host/interrupts.h"
#include "hal/host/register_memory.h"
#include "hal/host/timers.h"
#include "hal/host/waves.h"

namespace robosim {
namespace host {

ROBOSIM_CLOCKWORK Polling polling;

namespace {

constexpr int kPatience = 6;
constexpr int kMostBlocks = 300, kMostVisits = 70;  // limits of a look: blocks, and visits to its place
constexpr int kFarAway = 32;                        // blocks after which firmware must be in another loop
constexpr int kLongestWait = 64;                    // in deadlines, of which there are about two per ms

SimTime earlier(SimTime a, SimTime b) { return a < b ? a : b; }

void leave() {
  polling.on = false;
  unsettled = nullptr;
  deadline = polling.until;
}

void find_nothing() {
  leave();
  polling.known = polling.sure = false;
  polling.wait = polling.wait == 0 ? 1 : 2 * polling.wait < kLongestWait ? 2 * polling.wait : kLongestWait;
  polling.left = polling.wait;
}

/// Interrupts a look, because work is due or a call does more than a query.
void break_off() {
  if (polling.patience == 0) return find_nothing();
  --polling.patience;
  leave();
  if (state.now >= deadline) return;
  polling.known = polling.sure = false;
  polling.again = true;
  deadline = state.now;
}

void look_on() {
  polling.on = true;
  polling.until = deadline;
  polling.blocks = polling.visits = 0;
  polling.next_place = polling.next_take = 1;
  deadline = -1;
  unsettled = break_off;
}

void begin_round() {
  polling.going = polling.once = true;
  polling.since = state.now;
  polling.clock = polling.pins = polling.calls = polling.sure = false;
  polling.high = polling.low = PinSet();
  polling.promised = kNever;
  polling.points = polling.reads = 0;
}

/// Runs Timer 0's overflow handler in the round that begins now, at the first point after the overflow. The
/// handler delays the rest of the round. Returns false, without any change, if the round reads the handler's
/// counts after the overflow. Also returns false if another event, at `next`, is due in the round. `shift`
/// receives the handler's time if the round's last call is before the handler, else 0.
bool pass_overflow(SimTime next, SimTime& shift) {
  int point = polling.reads;
  while (point < polling.points && state.now + polling.at[point] < timer0.due()) ++point;
  if (point >= polling.points) return false;
  if (polling.reads > 0 && timer0.due() <= state.now + polling.at[polling.reads - 1]) return false;
  const SimTime ends = state.now + polling.length + kOverflowTakes;
  if (ends >= next || ends >= state.limit) return false;
  shift = polling.length - polling.call_ago < polling.at[point] ? kOverflowTakes : 0;
  state.now += polling.at[point];
  timer0.take_overflows();
  ++handlers_run;
  __vector_16();
  state.now = ends;
  return true;
}

/// Returns whether the counts of Timer 0's interrupt have changed since the round read them.
bool reads_anew() { return polling.clock && timer0_count.millis != polling.millis; }

/// Skips rounds. Returns false if there is no time for a complete round.
bool skip() {
  leave();
  const SimTime began = state.now, next = polling.pins || !interrupts_enabled() ? 0 : next_alone();
  SimTime due = next > 0 ? earlier(next, timer0.due()) : next_due(), shift = 0;
  for (;;) {
    const SimTime others =
        state.late_from > state.now ? earlier(state.next_input, state.late_from) : state.next_input;
    SimTime end = earlier(earlier(due, others), polling.promised);
    // The world may change at each tick.
    if (polling.pins || state.called_up) end = earlier(end, state.limit);
    SimTime rounds = end > state.now ? (end - 1 - state.now) / polling.length : 0;
    // Does not skip the last round, because the board records the time of the last read.
    if (polling.pins && rounds > 0) --rounds;
    const SimTime last = state.now + rounds * polling.length;
    if (last < state.limit) {
      if (rounds > 0) shift = 0;
      state.now = last;
      if (next == 0 || !pass_overflow(earlier(next, others), shift)) break;
      due = earlier(next, timer0.due());
      if (reads_anew()) break;
      continue;
    }
    state.polls = true;
    state.polls_by_calls = polling.calls;
    state.wake = next == 0 || polling.points < 0 || polling.clock ? last : next;
    executor->yield();
    state.polls = false;
  }
  deadline = earlier(due, state.limit);
  if (interrupts_enabled()) deadline = earlier(deadline, state.next_input);
  if (state.now == began) return false;
  if (polling.calls) state.last_call = state.now - polling.call_ago - shift;
  if (polling.read_ago < polling.length) state.read_at = state.now - polling.read_ago;
  return true;
}

/// Handles a return to `place` in an unchanged state. Returns false if work is due.
bool come_round() {
  if (reads_anew()) {
    begin_round();
    return true;
  }
  if (polling.pins && !polling.going) {  // pins may have changed with the tick
    polling.going = true;
    polling.promised = kNever;
    return true;
  }
  if (skip()) {
    polling.wait = polling.left = 0;
    polling.patience = kPatience;
    if (reads_anew() && state.now < deadline) {
      look_on();
      begin_round();
      return true;
    }
  } else {
    polling.until = deadline;
    find_nothing();
  }
  return state.now < deadline;
}

}  // namespace

void begin_look() {
  if (!state.may_skip || polling.on || state.watched || unsettled || in_handler()) return;
  if (adc.converts() && adc.next() == kNever) return;  // each round may change the next conversion's start
  if (state.now >= deadline) return;
  if (polling.left > 0 && --polling.left > 0) return;
  polling.going = false;
  if (!polling.known) polling.place = nullptr;
  look_on();
}

bool look_at_block() {
  if (state.now >= polling.until) {
    break_off();
    return false;
  }
  if (++polling.blocks > kMostBlocks || polling.visits > kMostVisits) {
    find_nothing();
    return true;
  }
  note_point();
  if (state.place != polling.place) {
    if (polling.blocks == kFarAway) polling.known = polling.sure = false;
    // As long as the place has not repeated, a later place replaces it after 1, 2, 4, … blocks.
    if (!polling.known && polling.blocks >= polling.next_place) {
      polling.place = state.place;
      polling.next_place *= 2;
    }
    return true;
  }
  if (polling.sure) return come_round();
  if (polling.take) {
    polling.known = true;
    begin_round();
    return true;
  }
  if (!polling.same) {
    polling.once = false;
    // A later state replaces the stored state after 1, 2, 4, … visits.
    if (++polling.visits < polling.next_take) return true;
    polling.next_take *= 2;
    polling.known = false;
    return true;
  }
  if (!polling.going) {
    begin_round();
    return true;
  }
  polling.length = state.now - polling.since;
  polling.millis = timer0_count.millis;
  polling.call_ago = state.now - state.last_call;
  polling.read_ago = state.now - state.read_at;
  polling.sure = polling.once;
  return come_round();
}

void look_at_level(Pin pin, bool high) {
  (high ? polling.high : polling.low).add(pin);
  polling.pins = true;
  polling.promised = earlier(polling.promised, executor->same_until(pin, state.now));
  if (is_wave(pin)) polling.promised = earlier(polling.promised, wave_until(pin));
}

void spend_late() {
  reach_deadline();
  begin_look();
}

}  // namespace host
}  // namespace robosim
