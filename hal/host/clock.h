// Firmware's time. Every call and every basic block advances it. At its deadline interrupts are served and
// the executor takes over.
#pragma once

#include "hal/board/firmware_port.h"
#include "hal/host/costs.h"
#include "hal/host/image.h"

/// Groups the variables that image.h calls clockwork, so that they are adjacent.
#define ROBOSIM_CLOCKWORK __attribute__((section("robosim_clockwork")))
/// Groups the large variables that image.h calls settings.
#define ROBOSIM_SETTINGS __attribute__((section("robosim_settings")))
/// Optimises rarely used code for size, since images are read and hashed at the start of each run.
#define ROBOSIM_RARE __attribute__((cold))
/// Inlines everything that a frequently called function calls.
#define ROBOSIM_FREQUENT __attribute__((flatten))

namespace robosim {
namespace host ROBOSIM_WITHIN {

extern FirmwareState state;
extern FirmwarePort* board;
/// The board's description of itself.
extern const BoardSpec* board_spec;
extern Host* executor;
/// The time of the next action: the limit, or an interrupt that is due earlier.
extern SimTime deadline;
/// Like `deadline`; earlier while blocks are observed and call block_at_deadline() before it.
extern SimTime watched_deadline;

/// Serves what is due, yields at the limit, and sets the next deadline.
void reach_deadline();
/// Returns the time of the next autonomous event: an interrupt that will be served, a reset, the end of a
/// tone.
SimTime next_due();
/// Recomputes the deadline. Call it after any change that moves an interrupt.
void refresh_deadline();

/// Like spend(), at a place where a polling look may begin (polling.h).
void spend_late();

/// Spends a short stretch of work. Interrupts that occur in it are served at its end.
inline void spend(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) spend_late();
}

void block_at_deadline();
/// Like spend(), in a basic block of firmware, which may be observed.
inline void spend_in_block(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) block_at_deadline();
}

/// Does `duration` of the processor's own work, which interrupts prolong.
void work(SimTime duration);

/// The time by which the next delay() is shortened, ns.
extern SimTime sooner;

void be_late();
/// Applies a Lateness that is due.
inline void be_late_if_due() {
  if (__builtin_expect(state.now >= state.late_from, 0)) be_late();
}

/// Waits for `time`, serving interrupts at their exact moments. Ends later only if a handler takes longer.
/// Its cost does not depend on the duration.
void wait_long(SimTime time);
inline void wait_until(SimTime time) {
  if (time >= deadline) return wait_long(time);
  if (time > state.now) state.now = time;
}

/// Like wait_long(), for firmware outside of an API call: it hangs.
void idle_until(SimTime time);

/// Waits for the next interrupt to be served. Interrupts must be enabled.
void wait_for_interrupt(bool timer0_counts);

/// Ends the firmware at its own request; `how` is the call as the sketch would write it. Does not return.
__attribute__((noreturn)) void stop_for_ever(const char* how);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
