// Declares the sensing and the moves for a navigation algorithm on Robosim's floor of cells.
//
// Write one file:
//
//   #include <robosim/cells.h>
//
//   void navigate(robosim::Cells& robot) {
//     while (robot.sense() == robosim::Sense::straight) robot.step_forward();
//   }
//
// and run it:   robosim classic d --algorithm ./mine.cpp
//
// The run ends when navigate() returns, or when the moves are used up (--steps). For details, see
// docs/reference/algorithms.md.
#pragma once

namespace robosim {

/// The pattern of line in four cells: ahead, right, left, and the robot's own cell.
enum class Sense {
  no_path,     ///< the line has ended
  straight,    ///< the line continues
  right_turn,  ///< the line bends to the right
  left_turn,
  junction  ///< three or four lines meet; drive onto the junction to find their directions
};

class Cells {
 public:
  virtual Sense sense() = 0;

  // Moves. Each takes the same time.
  virtual void step_forward() = 0;
  virtual void turn_right() = 0;    ///< onto the cell on the right, facing that way, in one move
  virtual void turn_left() = 0;     ///< onto the cell on the left, facing that way, in one move
  virtual void turn_around() = 0;   ///< on the spot
  virtual void choose_right() = 0;  ///< turn_right if the cell on the right is line, otherwise step_forward
  virtual void choose_left() = 0;   ///< turn_left if the cell on the left is line, otherwise step_forward

  /// Returns the number of moves so far.
  virtual unsigned long long moves() const = 0;
  /// Return the robot's place: column and row from the top left, and 'E', 'S', 'W' or 'N'. A real robot has
  /// no such information.
  virtual int x() const = 0;
  virtual int y() const = 0;
  virtual char facing() const = 0;
  /// Returns the number of different line ends that the robot has reached.
  virtual int dead_ends() const = 0;

 protected:
  ~Cells() = default;
};

}  // namespace robosim

/// The algorithm, which your file defines.
extern "C" __attribute__((visibility("default"))) void navigate(robosim::Cells& robot);
