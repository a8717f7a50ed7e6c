// The simulated Arduino robot in a session: one of Robosim's sketches, run by a runner, watched in the live
// view.
#pragma once

#include <string>

#include "sim/play/session.h"

namespace robosim::play {

/// Compiles the algorithm's sketch and runs it. Left and right end with the tour of all stations. With ai the
/// run pauses whenever the sketch asks for a destination, however long the user thinks, and continues with
/// the answer. Returns a sentence about the end. Throws as `robosim run` does.
std::string play_robot(const grid::Map& map, const grid::Start& start, Algorithm algorithm,
                       tui::Console& console, const AskPerson& ask);

}  // namespace robosim::play
