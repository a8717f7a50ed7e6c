// Finds bodies that are so far from all others that they cannot affect each other for a while. The simulation
// may then compute several ticks of each such body in a row.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/world/body.h"

namespace robosim::world {

class Separation {
 public:
  /// Computes the result of World::apart(). The result is valid until the next call.
  const std::vector<bool>& find(const std::vector<std::unique_ptr<Body>>& bodies,
                                const std::vector<double>& sights, double seconds);

 private:
  struct Room {
    Vec2 centre;
    // The body stays in the circle of `radius` about `centre`. Its sensors detect other bodies up to a
    // distance of `sight` from this circle.
    double radius, sight;  // m
    std::size_t number;
  };
  std::vector<Room> rooms_;  // sorted from west to east; used only during a call
  std::vector<bool> apart_;
};

}  // namespace robosim::world
