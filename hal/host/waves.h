// Pins that the chip itself toggles: by PWM, by a timer's toggle mode, by tone(). The board receives a duty
// cycle or frequency. Levels that the sketch reads there, and edges for its interrupts, are computed on
// demand for that moment.
#pragma once

#include "hal/board/board.h"
#include "hal/host/clock.h"
#include "hal/host/external.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Return the level of such a pin, and how long it certainly stays; kNever if it does not change.
bool wave_level(Pin pin);
SimTime wave_until(Pin pin);

/// The time of the next edge that has a listener.
extern SimTime wave_due;
/// Reports all such edges until now. Call it before a change that moves them.
ROBOSIM_RARE void tell_waves();
inline void sync_waves() {
  if (state.now >= wave_due) tell_waves();
}
/// Pins that have a listener.
extern PinSet followed;
void follow_anew();
/// Updates the waves after such a change, or after one pin has started or stopped toggling.
inline void refresh_waves() {
  if (followed.any()) follow_anew();
}
void refresh_wave(Pin pin);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
