// Defines the data that a competition's rules receive in each tick.
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
  bool moved = false;  ///< the body has moved 4 mm, turned a degree, or stopped since this was last true
};

}  // namespace robosim::judge
