// A simple re-implementation of Robosim v1's sensing, moving and scanning, based on measurements of v1. It is
// the reference for the cell engine's results and speed.
#pragma once

#include <string>
#include <vector>

#include "sim/map/map.h"

namespace robosim::cells::v1 {

struct Robot {
  const map::Map* map;
  int x, y;
  char facing;  ///< 'N', 'S', 'E' or 'W'
  long clock = 0;
  std::vector<std::string>* moves = nullptr;  ///< "x,y,dir,sense,move,clock" of each move, if requested

  /// Returns "no_path", "straight", "right_turn", "left_turn" or "junction".
  const char* sense() const;
  void step_forward();
  void turn_right();
  void turn_left();
  void turn_around();
  void choose_right();
  void choose_left();

 private:
  char at(int cx, int cy) const;  ///< '0', '1' or '2'; '?' outside of the map
  void side(char to, int& dx, int& dy) const;
  void note(const char* move);
};

struct Node {
  int no = 0;
  int visit = 0;
  int station[3] = {0, 0, 0};   ///< station's number by slot; 0 = none
  int junction[3] = {0, 0, 0};  ///< junction's number by slot; 0 = none
};

struct Scan {
  std::vector<Node> nodes;  ///< by number, from 1
  int stations = 1;
};

/// Runs v1's third scan algorithm. The map must be a tree of three-way junctions, with at least one junction.
/// The robot must start at a dead end, and face the line.
Scan scan(Robot& robot);

}  // namespace robosim::cells::v1
