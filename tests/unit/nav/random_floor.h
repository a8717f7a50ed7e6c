// Generates random networks for the tests of navigation. A seed gives the same floor on every machine.
#pragma once

#include <cstdint>
#include <random>

#include "floor.h"

namespace nav_test {

/// A source of random numbers. It does not use the standard library's distributions, because these differ
/// between libraries.
class Dice {
 public:
  explicit Dice(uint32_t seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<uint32_t>(n)); }
  bool oneIn(int n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

/// Returns a tree of stations and junctions, with `nodes` nodes or slightly fewer. Junctions have three arms.
/// If `four_way` is true, some have four.
Floor randomTree(Dice& dice, int nodes, bool four_way);

/// Returns a connected network of junctions whose arms are joined at random. It has cycles, parallel lines,
/// and lines from a junction to itself. Some arms end in stations.
Floor randomNet(Dice& dice, int junctions, int percent_stations);

/// Puts an obstacle on each line with a probability of 1 / `one_in`.
void blockSome(Dice& dice, Floor& floor, int one_in);

/// Returns a random place on the floor with a random heading.
Stand randomStand(Dice& dice, const Floor& floor);

}  // namespace nav_test
