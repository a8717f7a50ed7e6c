// The simulated Arduino robot in a session: a sketch of ours, run by a runner, watched in the live view.
#pragma once

#include <string>

#include "sim/play/session.h"

namespace robosim::play {

/// Compiles the algorithm's sketch and runs it. Left and right end with the tour of all stations. With ai the
/// run is cut whenever the sketch asks for a destination; the person is asked, and the same run is repeated
/// up to there with one line more in its script, which sends the answer. So no wall time gets into a run, and
/// the script repeats the whole of it. Gives a sentence about how it ended. Throws as `robosim run` does.
std::string play_robot(const grid::Map& map, const grid::Start& start, Algorithm algorithm,
                       tui::Console& console, const AskPerson& ask);

}  // namespace robosim::play
