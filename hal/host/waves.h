// Handles pins that the chip toggles without firmware: by PWM, by a timer's toggle mode, or by tone(). The
// board receives only a duty cycle or a frequency. This code computes the levels that the sketch reads at
// these pins, and the edges that cause interrupts.
#pragma once

#include "hal/board/board.h"
#include "hal/host/clock.h"
#include "hal/host/external.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Return the present level of a toggling pin, and the time of its next edge (kNever = no further edge).
bool wave_level(Pin pin);
SimTime wave_until(Pin pin);

/// The time of the next edge on any pin in `followed`.
extern SimTime wave_due;
/// Reports the edges of followed pins up to now. Call this before a change that moves their later edges.
ROBOSIM_RARE void tell_waves();
inline void sync_waves() {
  if (state.now >= wave_due) tell_waves();
}
/// The toggling pins that are in `heard` (external.h).
extern PinSet followed;
void follow_anew();
/// Updates all followed pins after a change that moves edges.
inline void refresh_waves() {
  if (followed.any()) follow_anew();
}
/// Updates a pin that starts or stops toggling.
void refresh_wave(Pin pin);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
