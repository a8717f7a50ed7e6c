// A navigation algorithm of your own, on cells: copy this file, change it, and run it.
//
//   robosim classic d --algorithm ./my_algorithm.cpp
//   robosim classic d --algorithm ./my_algorithm.cpp --trace
//
// This example tosses a coin at every junction until it has visited seven dead ends.

#include <robosim/cells.h>

#include <random>

void navigate(robosim::Cells& robot) {
  std::minstd_rand coin(1);  // the same tosses in every run
  while (robot.dead_ends() < 7) {
    switch (robot.sense()) {
      case robosim::Sense::straight:
        robot.step_forward();
        break;
      case robosim::Sense::right_turn:
        robot.turn_right();
        break;
      case robosim::Sense::left_turn:
        robot.turn_left();
        break;
      case robosim::Sense::no_path:
        robot.turn_around();
        break;
      case robosim::Sense::junction:
        if (coin() % 2 == 0) {
          robot.choose_left();
        } else {
          robot.choose_right();
        }
        break;
    }
  }
}
