// Finds bodies that are so far from all others that for a while none can affect another. The simulation may
// then compute several ticks of each body at a stretch.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/world/body.h"

namespace robosim::world {

class Separation {
 public:
  /// Returns for each body whether it can neither meet nor notice another one within `seconds`, nor be
  /// noticed, as World::apart defines it. Valid until the next call.
  const std::vector<bool>& find(const std::vector<std::unique_ptr<Body>>& bodies,
                                const std::vector<double>& sights, double seconds);

 private:
  struct Room {
    Vec2 centre;
    double radius, sight;  // m: of a circle that it does not leave; beyond that circle
    std::size_t number;
  };
  std::vector<Room> rooms_;  // within a call, from west to east
  std::vector<bool> apart_;
};

}  // namespace robosim::world
