// Random networks for the tests of navigation. The same seed gives the same floor on every machine.
#pragma once

#include <cstdint>
#include <random>

#include "floor.h"

namespace nav_test {

/// Random numbers below `n`. The standard library's distributions are not used, because they differ between
/// libraries.
class Dice {
 public:
  explicit Dice(uint32_t seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<uint32_t>(n)); }
  bool oneIn(int n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

/// Returns a tree of stations and junctions with three arms (with `four_way`, some with four). It has `nodes`
/// nodes, or slightly fewer.
Floor randomTree(Dice& dice, int nodes, bool four_way);

/// Returns junctions whose arms are joined at random: cycles, parallel lines, lines from a junction to
/// itself, and stations at the remaining arms. The network is connected.
Floor randomNet(Dice& dice, int junctions, int percent_stations);

/// Puts obstacles on some lines.
void blockSome(Dice& dice, Floor& floor, int one_in);

/// Returns a random place on the floor with a random heading.
Stand randomStand(Dice& dice, const Floor& floor);

}  // namespace nav_test
