// Runs along lines with three digital sensors and no encoders: a Walker (nav/Landmark.h).
//
//        L       M       R      The middle sensor runs along the left edge of the line; the other two are so
//        .       |####|  .      far apart that they see the floor, but for arms:
//        .       |####|  .
//
//   what passes under the sensors      what it is
//   L or R dark for about one width    an arm; the time it takes is the ruler for what follows
//   all white for a while              look a little to both sides: the line goes on, or has ended
//
// (The paper's robot steers by the side sensors, 110 and 011, so that it cannot tell an arm on one side from
// a line that slips away. Its junctions are those where it sees 111.)
//
// After an arm the robot rolls on until its axle is over it, and looks for the line ahead. Two arms with the
// one it came by, and it goes round the bend; more, and it is a junction; no line at all is an end.
//
// Times are in steps of Pony::kStepMs. The ruler: a line is 20 mm wide, so the time for which an arm was dark
// is the time for 20 mm, and a pulsed motor keeps its speed for so long. A full turn on the spot at the
// beginning tells what is around, and how long a quarter turn takes.
//
// What stands in the way for longer than the collision sensor's patience is reported as `blocked`.
//
// Without encoders it does not know places (kKnowsPlaces): trees only.
#ifndef PONY_WALKER_H
#define PONY_WALKER_H

#include <nav/Landmark.h>

#include "Pony.h"

class PonyWalker {
 public:
  static const bool kKnowsPlaces = false;

  explicit PonyWalker(Pony& pony) : pony_(pony) {}

  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place&) {}

 private:
  /// Follows the line's edge until an arm begins (true), or there has been no line for a while, or it is
  /// blocked.
  bool followEdge();
  /// The arms that pass while the robot goes straight on: 1 left, 2 right; 0 if it was none.
  uint8_t cross();
  void roll();
  void backOff();
  void stop();
  /// Turns a little to both sides to find the line.
  bool lookAhead();
  /// Turns on the spot, `dir` 1 to the right and -1 to the left, for at most so many steps; true at the line.
  bool turnToLine(int8_t dir, uint16_t steps);
  /// Turns on the spot to the `count`-th line, which is so many quarters away. False if it is not there.
  bool turn(int8_t dir, uint8_t quarters, uint8_t count);
  void spin(int8_t dir, uint8_t duty) {
    pony_.step(static_cast<int8_t>(dir * duty), static_cast<int8_t>(-dir * duty));
  }
  nav::Landmark landmark(nav::LandmarkKind kind);
  void turned(nav::Turn turn) { heading_ = nav::turned(heading_, turn); }
  void addArm(nav::Turn side) { arms_ = static_cast<uint8_t>(arms_ | 1 << nav::turned(heading_, side)); }

  Pony& pony_;
  nav::Heading heading_ = 0;
  uint8_t arms_ = 0;  ///< of the last landmark
  bool lost_ = false;
  uint16_t width_ = 85;     ///< steps for 20 mm
  uint16_t quarter_ = 346;  ///< steps for a quarter turn
  uint32_t left_at_ = 0;    ///< ms, when the last landmark was left
};

#endif
