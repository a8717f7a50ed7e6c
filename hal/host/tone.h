// tone(): Timer 2 toggles one pin. As in the AVR core, this takes Timer 2 from analogWrite on pins 3 and 11.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// The end of the current tone; kNever if there is none, or it is endless.
extern SimTime tone_end;
/// Returns whether a tone sounds.
bool sounds();
/// Return the level of its pin at a moment since its last change, and when it changes next.
bool tone_level(SimTime at);
SimTime next_tone_edge(SimTime after);
/// Ends the tone if its time has come.
ROBOSIM_RARE void end_tone();
inline void sync_tone() {
  if (state.now >= tone_end) end_tone();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
