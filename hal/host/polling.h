// Skips firmware that only waits by polling. Such firmware returns to a place with the same variables, heap,
// stack and registers as before. All its queries are certain to have the same answers for some time. So it
// repeats the same round, of the same length, until that time is over. As many rounds as certainly fit
// into it are skipped, except the last; the result is the same as running them.
//
// At a deadline a look begins: from then on each basic block calls look_at_block(). The look ends when rounds
// have been skipped or when it takes too long. It also ends at a call that does more than those marked by
// note_question(). Looks without success become ever rarer.
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

  bool on = false;     ///< a look is in progress; `deadline` is then always over, the true one is `until`
  bool known = false;  ///< the executor has the state at `place`
  bool going = false;  ///< a round has begun at `since`
  bool take = false;   ///< the state must be taken, not compared
  bool same = false;   ///< the result of the comparison
  bool clock = false;  ///< the round reads what Timer 0's interrupt counts,
  bool pins = false;   ///< or pins,
  bool once = false;   ///< the round comes to `place` once
  bool calls = false;  ///< or calls something at all
  bool again = false;  ///< interrupted: the next block starts a look again, even if something is due
  bool sure = false;   ///< the state is on the round of `length`: all answers have been equal since then
  int patience = 0;    ///< remaining calls that may interrupt a look before looks become rarer
  int wait = 0,
      left = 0;  ///< deadlines between a failed look and the next, and the remaining ones
  int blocks = 0, visits = 0, next_place = 0, next_take = 0;
  const void* place = nullptr;
  SimTime until = 0;
  SimTime since = 0, length = 0;
  SimTime call_ago = 0, read_ago = 0;  ///< at `place`: since the last call and the last read
  // The points at which the round may be interrupted: their offset from its beginning, and their number.
  // Below 0: too many. Up to the first of them after `reads` it may see what Timer 0's interrupt counts.
  SimTime at[kMostPoints] = {};
  int points = 0, reads = 0;
  SimTime promised = kNever;  ///< until when pins surely keep their values
  uint64_t millis = 0;        ///< of the round of `length`,
  PinSet high, low;           ///< and its pins
};
extern Polling polling;

/// Starts a look if one may begin: after a deadline, in a block or a call.
void begin_look();
/// Handles the beginning of a block during a look. Returns whether the executor is to compare the state, or
/// take it if `polling.take` is set. Afterwards false means that the look is over and due work must be done.
inline bool look_wants_state() {
  if (polling.sure || state.now >= polling.until || state.place != polling.place) return false;
  polling.take = !polling.known;
  return true;
}
bool look_at_block();
void look_at_level(Pin pin, bool high);
/// Abandons the round of `length`: a query had another answer, or a handler has run.
inline void leave_round() {
  if (!polling.sure) return;
  polling.sure = polling.going = false;
}
/// Records that the sketch has read the level of a pin.
inline void note_level(Pin pin, bool high) {
  if (!(high ? polling.high : polling.low).has(pin)) leave_round();
  if (__builtin_expect(polling.on, 0)) look_at_level(pin, high);
}
/// Records that the sketch has read what Timer 0's interrupt counts.
inline void note_clock() {
  polling.clock = true;
  polling.reads = polling.points + 1;  // when its time is spent
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
/// Spends work in a call that changes nothing.
inline void spend_asking(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now < deadline, 1)) return;
  if (polling.on && state.now < polling.until) return note_point();
  spend_late();
}

/// Spends work between two calls of loop(), where no look may begin: the sketch has no place there.
inline void spend_between_loops(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now < deadline, 1)) return;
  if (polling.on && state.now < polling.until) return note_point();
  block_at_deadline();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
