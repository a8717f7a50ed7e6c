// The input of a competition's rules in each tick.
#pragma once

#include <vector>

#include "hal/board/sim_time.h"
#include "sim/result/events.h"
#include "sim/result/run_result.h"

namespace robosim::world {
class Body;
}

namespace robosim::judge {

/// The events of a tick.
using Events = std::vector<result::RunEvent::What>;

struct RulesInput {
  const world::Body& body;
  SimTime t = 0;
  bool at_rest = false;
  bool moved = false;  ///< the body moved 4 mm or a degree since this was last true, or has just stopped
};

}  // namespace robosim::judge
