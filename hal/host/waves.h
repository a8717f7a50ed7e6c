// Pins that the chip itself drives up and down: by PWM, by a timer that toggles them, by tone(). The board is
// told a duty or a frequency; what the sketch reads there, and the edges that its interrupts hear, are
// computed when somebody asks, as of that moment.
#pragma once

#include "hal/board/board.h"
#include "hal/host/clock.h"
#include "hal/host/external.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Of a pin that is one now: its level, and until when that surely stays; kNever if it does not change.
bool wave_level(Pin pin);
SimTime wave_until(Pin pin);

/// When the next edge comes that somebody listens to.
extern SimTime wave_due;
/// Tells all such edges until now: before anything changes that says when they come.
ROBOSIM_RARE void tell_waves();
inline void sync_waves() {
  if (state.now >= wave_due) tell_waves();
}
/// Pins to which somebody listens.
extern PinSet followed;
void follow_anew();
/// After such a change; and where one pin may have become one of those, or none any more.
inline void refresh_waves() {
  if (followed.any()) follow_anew();
}
void refresh_wave(Pin pin);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
