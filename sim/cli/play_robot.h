// The simulated Arduino robot in a session: a sketch of ours, run by a runner, watched in the live view.
#pragma once

#include <string>

#include "sim/view/session.h"

namespace robosim::cli {

/// Compiles the algorithm's sketch and runs it on robot uno5. Gives a sentence about how it ended. Throws as
/// `robosim run` does.
std::string play_robot(const grid::Map& map, const grid::Start& start, view::Algorithm algorithm,
                       view::Console& console);

}  // namespace robosim::cli
