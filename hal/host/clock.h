// Firmware's time: every call and every basic block advances it; at its deadline interrupts are served and
// the executor takes over.
#pragma once

#include "hal/board/firmware_port.h"
#include "hal/host/costs.h"
#include "hal/host/image.h"

/// Of variables that image.h calls the clockwork: they lie together.
#define ROBOSIM_CLOCKWORK __attribute__((section("robosim_clockwork")))
/// Of large ones that image.h calls settings.
#define ROBOSIM_SETTINGS __attribute__((section("robosim_settings")))
/// What few sketches come to, or seldom, is made small: images are read, and hashed, whenever a run begins.
#define ROBOSIM_RARE __attribute__((cold))
/// What sketches call again and again has all inlined that it calls itself.
#define ROBOSIM_FREQUENT __attribute__((flatten))

namespace robosim {
namespace host ROBOSIM_WITHIN {

extern FirmwareState state;
extern FirmwarePort* board;
/// What it says of itself.
extern const BoardSpec* board_spec;
extern Host* executor;
/// When something has to be done: the limit, or an interrupt that is due before it.
extern SimTime deadline;
/// The same, where blocks are watched and come to block_at_deadline() before it.
extern SimTime watched_deadline;

/// Serves what is due, yields at the limit, and sets the next deadline.
void reach_deadline();
/// When the next thing happens by itself: an interrupt that will be served, a reset, the end of a tone.
SimTime next_due();
/// To be called after anything that changes when an interrupt is due.
void refresh_deadline();

/// The same where a look may begin (polling.h).
void spend_late();

/// A short stretch of work. Interrupts that fall into it are served at its end.
inline void spend(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) spend_late();
}

void block_at_deadline();
/// The same in a basic block of firmware, which may be watched.
inline void spend_in_block(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) block_at_deadline();
}

/// Work that interrupts prolong: `duration` of the processor's own time.
void work(SimTime duration);

/// By how much the next delay() shall be shorter, ns.
extern SimTime sooner;

void be_late();
/// Lets Lateness pass that is due.
inline void be_late_if_due() {
  if (__builtin_expect(state.now >= state.late_from, 0)) be_late();
}

/// Waits for `time` while interrupts are served at their exact moment; ends later only if a handler takes
/// longer. Costs nothing however long it is.
void wait_long(SimTime time);
inline void wait_until(SimTime time) {
  if (time >= deadline) return wait_long(time);
  if (time > state.now) state.now = time;
}

/// The same for firmware that is not in a call of the API: it hangs.
void idle_until(SimTime time);

/// Waits for the next interrupt to be served. Interrupts must be enabled.
void wait_for_interrupt(bool timer0_counts);

/// Firmware has ended itself; `how` as the sketch would write it. Does not return.
__attribute__((noreturn)) void stop_for_ever(const char* how);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
