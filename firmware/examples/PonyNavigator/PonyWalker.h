// Follows lines with three digital sensors and no encoders, and detects junctions: a Walker (nav/Landmark.h).
//
//        L       M       R      The middle sensor follows the left edge of the line. The side sensors are
//        .       |####|  .      wide apart, so that they see the floor except at arms:
//        .       |####|  .
//
//   under the sensors                  meaning
//   L or R dark for about one width    an arm; the time in the dark calibrates the next distances
//   all white for a while              the line has ended, unless a search on both sides finds it
//
// (The robot of the Pony paper, docs/howto/research.md, steers by the patterns 110 and 011 of L, M and R. It
// therefore cannot distinguish an arm on one side from a drift off the line. Only 111 is a junction for it.)
//
// After an arm the robot rolls on until its axle is over the arm, and searches for the line ahead. Two arms,
// including the arm of arrival, make a bend; more make a junction. If the arm of arrival is the only arm, the
// line has ended.
//
// Times are in steps of Pony::kStepMs. A line is 20 mm wide, so the duration of an arm is the time for 20 mm.
// The motor speed is stable enough to use this time for the next distances. The first full turn on the spot
// detects the lines around the robot, and measures the duration of a quarter turn.
//
// An obstacle that stays longer than Pony::kPatienceMs is reported as `blocked`.
//
// Without encoders the walker does not recognise places (kKnowsPlaces), so maps must be trees.
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
  /// Follows the line's edge. Returns true when an arm begins; false if the line ends or the robot is
  /// blocked.
  bool followEdge();
  /// Drives straight on across arms. Returns 1 for a left arm, 2 for a right arm, 3 for both, 0 for none.
  uint8_t cross();
  void roll();
  void backOff();
  void stop();
  /// Turns a little to both sides to find the line.
  bool lookAhead();
  /// Turns on the spot for at most `steps`; `dir` is 1 to the right, -1 to the left. Returns true at a line.
  bool turnToLine(int8_t dir, uint16_t steps);
  /// Turns on the spot to the `count`-th line, `quarters` quarter turns away. Returns false if that line is
  /// not found.
  bool turn(int8_t dir, uint8_t quarters, uint8_t count);
  void spin(int8_t dir, uint8_t duty) {
    pony_.step(static_cast<int8_t>(dir * duty), static_cast<int8_t>(-dir * duty));
  }
  nav::Landmark landmark(nav::LandmarkKind kind);
  void turned(nav::Turn turn) { heading_ = nav::turned(heading_, turn); }
  void addArm(nav::Turn side) { arms_ = static_cast<uint8_t>(arms_ | 1 << nav::turned(heading_, side)); }

  Pony& pony_;
  nav::Heading heading_ = 0;
  uint8_t arms_ = 0;  ///< arms of the last landmark
  bool lost_ = false;
  uint16_t width_ = 85;     ///< steps for 20 mm
  uint16_t quarter_ = 346;  ///< steps for a quarter turn
  uint32_t left_at_ = 0;    ///< time when the robot left the last landmark, in ms
};

#endif
