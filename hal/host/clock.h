// The firmware's clock. Every call and every basic block advances it. At the deadline, interrupts are served
// and the executor takes over.
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
/// The board's specification.
extern const BoardSpec* board_spec;
extern Host* executor;
/// The time of the next action: the limit, or an earlier interrupt.
extern SimTime deadline;
/// The real deadline while blocks are observed. `deadline` is then earlier, so that each block is reported.
extern SimTime watched_deadline;

/// Serves due interrupts, yields at the limit, and sets the next deadline.
void reach_deadline();
/// Returns the time of the next autonomous event: an interrupt that will be served, a reset, or the end of a
/// tone.
SimTime next_due();
/// Recomputes the deadline. Call it after any change that may move an interrupt.
void refresh_deadline();

/// Serves due events, and may begin a polling look (polling.h).
void spend_late();

/// Spends the time of a short piece of code. Interrupts that occur meanwhile are served at its end.
inline void spend(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) spend_late();
}

void block_at_deadline();
/// Variant of spend() for a basic block of firmware, which may be observed.
inline void spend_in_block(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) block_at_deadline();
}

/// Spends `duration` of processor time. Interrupts prolong it.
void work(SimTime duration);

/// The amount by which the next delay() is shortened, ns.
extern SimTime sooner;

void be_late();
/// Applies a Lateness that is due.
inline void be_late_if_due() {
  if (__builtin_expect(state.now >= state.late_from, 0)) be_late();
}

/// Waits until `time`, and serves interrupts at their exact times. Ends later only if a handler takes longer.
/// The host's effort does not depend on the duration.
void wait_long(SimTime time);
inline void wait_until(SimTime time) {
  if (time >= deadline) return wait_long(time);
  if (time > state.now) state.now = time;
}

/// Variant of wait_long() for firmware that hangs outside of an API call.
void idle_until(SimTime time);

/// Waits until the next interrupt is served. Interrupts must be enabled.
void wait_for_interrupt(bool timer0_counts);

/// Ends the firmware at its own request. `how` is the call as the sketch would write it. Does not return.
__attribute__((noreturn)) void stop_for_ever(const char* how);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
