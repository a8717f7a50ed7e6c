// Random networks for the tests of navigation. The same seed gives the same floor, everywhere.
#pragma once

#include <cstdint>
#include <random>

#include "floor.h"

namespace nav_test {

/// Random numbers below `n`; the standard's distributions differ between libraries.
class Dice {
 public:
  explicit Dice(uint32_t seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<uint32_t>(n)); }
  bool oneIn(int n) { return below(n) == 0; }

 private:
  std::mt19937 engine_;
};

/// Returns a tree of junctions with three arms (or, each with a chance, four) and stations; at most `nodes`
/// nodes, and hardly less.
Floor randomTree(Dice& dice, int nodes, bool four_way);

/// Junctions whose arms are joined at random: cycles, parallel lines, lines from a junction to itself, and
/// stations on the arms left over. All of it hangs together.
Floor randomNet(Dice& dice, int junctions, int percent_stations);

/// Puts obstacles on some lines.
void blockSome(Dice& dice, Floor& floor, int one_in);

/// Returns a place anywhere on the floor, facing anywhere.
Stand randomStand(Dice& dice, const Floor& floor);

}  // namespace nav_test
