// Skips the time in which firmware only polls. Polling firmware returns to a place in its code with unchanged
// variables, heap, stack and registers. The way from this place until the return is called a round. All
// rounds are equal until a query (millis(), digitalRead(), Serial.available()) may return another result. The
// rounds that certainly end before that moment are skipped. If rounds read pins, the last of these rounds is
// executed. The result is the same as without skipping.
//
// A look is a search for such a place. It begins at a deadline; from then on, each basic block calls
// look_at_block(). The look ends after rounds have been skipped, after too many blocks, or at a call other
// than a query (api.h). If looks skip nothing, they become rarer.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/host/clock.h"
#include "hal/host/external.h"
#include "hal/host/timers.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

struct Polling {
  static constexpr int kMostPoints = 6;

  bool on = false;     ///< a look is in progress: `deadline` is in the past, `until` is the real deadline
  bool known = false;  ///< the executor has stored the state at `place`
  bool going = false;  ///< a round began at `since`
  bool take = false;   ///< the state must be stored, not compared
  bool same = false;   ///< result of the comparison
  bool clock = false;  ///< the round reads the counts of Timer 0's interrupt
  bool pins = false;   ///< the round reads pins
  bool once = false;   ///< the round passes `place` only once
  bool calls = false;  ///< the round calls the API
  bool again = false;  ///< a look was interrupted; the next block starts another look, even if work is due
  bool sure = false;   ///< the state repeats after `length`, and queries still return the same results
  int patience = 0;    ///< number of calls that may still interrupt a look before looks become rarer
  int wait = 0,        ///< number of deadlines from a failed look to the next look
      left = 0;        ///< number of these deadlines that remain
  int blocks = 0, visits = 0, next_place = 0, next_take = 0;
  const void* place = nullptr;
  SimTime until = 0;
  SimTime since = 0, length = 0;
  SimTime call_ago = 0, read_ago = 0;  ///< the times since the last call and the last read, at `place`
  // The points at which the round may be interrupted: offsets from the round's beginning, and their number. A
  // negative `points` means too many. The round reads the counts of Timer 0's interrupt only before the
  // point at[reads].
  SimTime at[kMostPoints] = {};
  int points = 0, reads = 0;
  SimTime promised = kNever;  ///< time before which the pins that were read certainly do not change
  uint64_t millis = 0;        ///< the result of millis() in the round that was measured as `length`
  PinSet high, low;           ///< in the same round: pins that were read as high, and as low
};
extern Polling polling;

/// Starts a look, if allowed. Call this function after a deadline, in a block or in an API call.
void begin_look();
/// Returns whether the executor must compare the firmware's state, or store it if `polling.take` is set. Call
/// this function at the beginning of a block, and look_at_block() after it.
inline bool look_wants_state() {
  if (polling.sure || state.now >= polling.until || state.place != polling.place) return false;
  polling.take = !polling.known;
  return true;
}
/// Continues the look at the beginning of a block. Returns false if the look is over and work is due.
bool look_at_block();
void look_at_level(Pin pin, bool high);
/// Abandons the round, because a query returned another result or a handler has run.
inline void leave_round() {
  if (!polling.sure) return;
  polling.sure = polling.going = false;
}
/// Records that the sketch has read the level of a pin.
inline void note_level(Pin pin, bool high) {
  if (!(high ? polling.high : polling.low).has(pin)) leave_round();
  if (__builtin_expect(polling.on, 0)) look_at_level(pin, high);
}
/// Records that the sketch has read the counts of Timer 0's interrupt.
inline void note_clock() {
  polling.clock = true;
  polling.reads = polling.points + 1;  // the point at which the call's time is spent
  if (timer0_count.millis != polling.millis) leave_round();
}
/// Marks a point at which a round may be interrupted.
inline void note_point() {
  if (!polling.going || polling.sure || polling.pins || polling.points < 0) return;
  if (polling.points == Polling::kMostPoints)
    polling.points = -1;
  else
    polling.at[polling.points++] = state.now - polling.since;
}
void spend_late();
/// Spends the time of a query: `count` CPU cycles.
inline void spend_asking(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now < deadline, 1)) return;
  if (polling.on && state.now < polling.until) return note_point();
  spend_late();
}

/// Spends the time between two calls of loop(). A round cannot begin here, because this code is not part of
/// the sketch.
inline void spend_between_loops(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now < deadline, 1)) return;
  if (polling.on && state.now < polling.until) return note_point();
  block_at_deadline();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
