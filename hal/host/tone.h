// tone(): Timer 2 toggles one pin. As in the AVR core it takes Timer 2 from analogWrite on pins 3 and 11.
#pragma once

#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// When the tone that sounds ends; kNever if none does, or it has no end.
extern SimTime tone_end;
/// Whether one does.
bool sounds();
/// The level of its pin at a moment since it was last changed, and when behind that it changes next.
bool tone_level(SimTime at);
SimTime next_tone_edge(SimTime after);
/// It is ended where its time has come.
ROBOSIM_RARE void end_tone();
inline void sync_tone() {
  if (state.now >= tone_end) end_tone();
}

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
