// Pins that the chip toggles without firmware: by PWM, by a timer's toggle mode, or by tone(). The board
// receives a duty cycle or frequency. The levels that the sketch reads there, and the edges for its
// interrupts, are computed on demand.
#pragma once

#include "hal/board/board.h"
#include "hal/host/clock.h"
#include "hal/host/external.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Return the level of such a pin, and how long it certainly stays; kNever if it never changes.
bool wave_level(Pin pin);
SimTime wave_until(Pin pin);

/// The time of the next edge on a followed pin.
extern SimTime wave_due;
/// Reports all edges of followed pins until now. Call it before a change that moves such edges.
ROBOSIM_RARE void tell_waves();
inline void sync_waves() {
  if (state.now >= wave_due) tell_waves();
}
/// Toggling pins whose edges have a listener.
extern PinSet followed;
void follow_anew();
/// Updates the waves. Call it after a change that moves edges, or after a pin starts or stops toggling.
inline void refresh_waves() {
  if (followed.any()) follow_anew();
}
void refresh_wave(Pin pin);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
