// Models tone() on the host: Timer 2 toggles one pin. During a tone, analogWrite() causes no PWM on pins 3
// and 11, as in the AVR core.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// The end of the current tone; kNever if no tone plays or the tone is endless.
extern SimTime tone_end;
/// Returns whether a tone plays.
bool sounds();
/// Return the level of the tone's pin at `at`, and the time of the pin's next change after `after`.
bool tone_level(SimTime at);
SimTime next_tone_edge(SimTime after);
/// Ends the tone. Call it when tone_end has passed.
ROBOSIM_RARE void end_tone();
inline void sync_tone() {
  if (state.now >= tone_end) end_tone();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
