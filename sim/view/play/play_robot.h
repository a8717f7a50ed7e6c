// Runs one of Robosim's sketches on the simulated Arduino robot, as part of a session. Shows the run in the
// live view.
#pragma once

#include <string>

#include "sim/view/play/session.h"

namespace robosim::play {

/// Compiles the algorithm's sketch and runs it. With `left` or `right`, the run ends when the robot has
/// toured all stations. With `ai`, the run pauses whenever the sketch requests a destination, and continues
/// with the user's answer. Returns a sentence about the end. Throws the errors of `robosim run`.
std::string play_robot(const map::Map& map, const map::Start& start, Algorithm algorithm,
                       terminal::Console& console, const AskPerson& ask);

}  // namespace robosim::play
