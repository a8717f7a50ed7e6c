// Runs the simulated Arduino robot in a session with one of Robosim's sketches. Shows it in the live view.
#pragma once

#include <string>

#include "sim/view/play/session.h"

namespace robosim::play {

/// Compiles the algorithm's sketch and runs it. `left` and `right` end with the tour of all stations. With
/// `ai`, the run pauses whenever the sketch asks for a destination, and continues with the user's answer.
/// Returns a sentence about the end. Throws the errors of `robosim run`.
std::string play_robot(const map::Map& map, const map::Start& start, Algorithm algorithm,
                       terminal::Console& console, const AskPerson& ask);

}  // namespace robosim::play
