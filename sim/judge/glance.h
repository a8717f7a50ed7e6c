// What a competition's rules look at, once a tick.
#pragma once

#include <vector>

#include "hal/board/sim_time.h"
#include "sim/wire/events.h"
#include "sim/wire/run_result.h"

namespace robosim::world {
class Body;
}

namespace robosim::judge {

/// What has happened in a tick.
using Events = std::vector<wire::RunEvent::What>;

struct Glance {
  const world::Body& body;
  SimTime t = 0;
  bool at_rest = false;
  bool moved = false;  ///< by 4 mm or a degree since this was last true, or it has just stopped
};

}  // namespace robosim::judge
