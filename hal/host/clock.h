// The firmware's clock. Every API call and every basic block advances the clock. At the deadline, the
// firmware serves due interrupts, or yields to the executor.
#pragma once

#include "hal/board/firmware_port.h"
#include "hal/host/costs.h"
#include "hal/host/image.h"

/// Places a variable between Image::clockwork_begin and clockwork_end (image.h).
#define ROBOSIM_CLOCKWORK __attribute__((section("robosim_clockwork")))
/// Places a large variable between Image::settings_begin and settings_end (image.h).
#define ROBOSIM_SETTINGS __attribute__((section("robosim_settings")))
/// Optimises rarely used code for size, because images are read and hashed at the start of each run.
#define ROBOSIM_RARE __attribute__((cold))
/// Inlines everything that a frequently called function calls.
#define ROBOSIM_FREQUENT __attribute__((flatten))

namespace robosim {
namespace host ROBOSIM_WITHIN {

extern FirmwareState state;
extern FirmwarePort* board;
/// The board's specification.
extern const BoardSpec* board_spec;
/// The board's present supply voltage.
extern const double* supply_volts;
extern Host* executor;
/// The time at which the firmware must stop to serve an interrupt or another event. At most state.limit.
extern SimTime deadline;
/// The real deadline while basic blocks are reported (FirmwareState::watched). `deadline` is then earlier, so
/// that each block is reported.
extern SimTime watched_deadline;

/// Serves due interrupts, yields at the limit, and sets the next deadline.
void reach_deadline();
/// Returns the time of the next event that the chip causes: an interrupt that will be served, a reset, or the
/// end of a tone.
SimTime next_due();
/// Recomputes the deadline. Call it after any change that may move an interrupt.
void refresh_deadline();

/// Serves due events. Then, if allowed, begins a search for idle polling to skip (begin_look() in polling.h).
void spend_late();

/// Spends the time of a short piece of code: `count` CPU cycles. Interrupts that occur during this time are
/// served at its end.
inline void spend(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) spend_late();
}

void block_at_deadline();
/// Variant of spend() for a basic block of firmware, which may have to be reported to the executor.
inline void spend_in_block(int count) {
  state.now += cycles(count);
  if (__builtin_expect(state.now >= deadline, 0)) block_at_deadline();
}

/// Spends `duration` of processor time. The time of interrupt handlers is added.
void work(SimTime duration);

/// The time by which the next delay() is shortened (Lateness in image.h).
extern SimTime sooner;

void be_late();
/// Applies a Lateness (image.h) that is due.
inline void be_late_if_due() {
  if (__builtin_expect(state.now >= state.late_from, 0)) be_late();
}

/// Waits until `time`, and serves interrupts at their exact times. Ends later only if a handler is still
/// running at `time`. The computing time does not depend on the duration.
void wait_long(SimTime time);
inline void wait_until(SimTime time) {
  if (time >= deadline) return wait_long(time);
  if (time > state.now) state.now = time;
}

/// Variant of wait_long() for firmware that waits outside of an API call, for example in an endless loop.
void idle_until(SimTime time);

/// Waits until the next interrupt is served. Interrupts must be enabled. If `timer0_counts`, Timer 0's
/// overflow also ends the wait.
void wait_for_interrupt(bool timer0_counts);

/// Ends the firmware at its own request. `how` is the reason, such as "exit(0)". Does not return.
__attribute__((noreturn)) void stop_for_ever(const char* how);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
