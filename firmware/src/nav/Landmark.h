// The interface between navigation and robots: landmarks on a network of lines, and the turns at them.
//
// A network of lines has nodes of two kinds: junctions, where three or four lines meet at right angles, and
// stations, where a line ends. Between nodes a line may bend; navigation ignores the bends.
//
// A Walker is any type with these members. It moves the robot along lines, and does not use the graph. There
// are several walkers: one moves from cell to cell on a simulator's grid, others drive motors.
//
//   static const bool kKnowsPlaces;       // whether Landmark::at is valid (odometry)
//   nav::Landmark begin();                // detects the lines around the robot at the start, see below
//   nav::Landmark follow();               // runs along the line, round bends, until it meets a landmark
//   void leave(nav::Turn turn);           // turns at the landmark; follow() then runs in that direction
//   void relocate(const nav::Place& at);  // sets the position of the last landmark
//
// begin() returns `junction` or `line` if the robot stands on a junction or in the middle of a line. It
// returns `end` if a line leaves in one direction only; the robot then faces that direction. An `end` with no
// arms is a single spot without any line to follow. begin() returns `lost` if there is no line.
//
// follow() returns `junction` when the robot stands on a junction. It returns `end` when the robot stands at
// the line's end and still faces outward. It returns `blocked` when the robot faces an obstacle. `loop` means
// that the robot has returned to its start without meeting a landmark. `lost` means that the robot's position
// is unknown.
//
// After `end` and `blocked` the only turn is Turn::back. At a junction, Turn::back turns the robot to the
// line of arrival.
#ifndef LINEKIT_NAV_LANDMARK_H
#define LINEKIT_NAV_LANDMARK_H

#include <stdint.h>

namespace nav {

/// A direction in quarter turns clockwise, 0..3. 0 is the robot's initial direction.
typedef uint8_t Heading;

/// A turn in quarter turns clockwise: heading + turn, modulo 4, is the new heading.
enum class Turn : uint8_t { straight = 0, right = 1, back = 2, left = 3 };

inline Heading turned(Heading h, Turn t) { return static_cast<Heading>((h + static_cast<uint8_t>(t)) & 3); }
inline Heading opposite(Heading h) { return static_cast<Heading>((h + 2) & 3); }
/// Returns the turn that leads from one heading to another.
inline Turn turnBetween(Heading from, Heading to) { return static_cast<Turn>((to - from) & 3); }

/// A place relative to the robot's initial pose: x points ahead, and y to the right. The unit is a cell on a
/// grid, or a millimetre on a floor.
struct Place {
  int32_t x, y;
};

/// Returns the place rotated about the start by this number of quarter turns clockwise.
inline Place rotated(Place at, uint8_t quarters) {
  for (quarters &= 3; quarters > 0; --quarters) at = {-at.y, at.x};
  return at;
}

enum class LandmarkKind : uint8_t { line, junction, end, blocked, loop, lost };

struct Landmark {
  LandmarkKind kind;
  uint8_t arms;     ///< lines that leave this place, including the line of arrival: bit 1 << Heading for each
  Heading heading;  ///< heading of the robot at the landmark
  Place at;
  uint32_t cost;  ///< cost since the last landmark: number of moves on a grid, else time in units of 20 ms
};

/// Returns the arms rotated clockwise: the arm at heading h is then at heading h + quarters.
inline uint8_t rotatedArms(uint8_t arms, uint8_t quarters) {
  quarters &= 3;
  return static_cast<uint8_t>((arms << quarters | (arms & 15) >> (4 - quarters)) & 15);
}

inline bool hasArm(uint8_t arms, Heading h) { return (arms >> h & 1) != 0; }

// A slot is the number of an arm at a junction. Slot 0 is the arm by which the robot first entered. The other
// slots follow from right to left, as seen from that arm (right, straight, left). Only existing arms count,
// so a junction with three arms has slots 0, 1, 2.

/// Returns the number of arms.
inline uint8_t slotCount(uint8_t arms) {
  return static_cast<uint8_t>((arms & 1) + (arms >> 1 & 1) + (arms >> 2 & 1) + (arms >> 3 & 1));
}

/// Returns the heading in which the arm in a slot leaves. `entry` is the heading in which the junction was
/// first entered, so the arm in slot 0 leaves in the opposite heading. `slot` < slotCount(arms).
inline Heading headingOf(uint8_t arms, Heading entry, uint8_t slot) {
  Heading h = opposite(entry);
  for (;;) {
    if (hasArm(arms, h) && slot-- == 0) return h;
    h = static_cast<Heading>((h + 3) & 3);
  }
}

/// Returns the slot of the arm that leaves in heading `h`. The arm must exist.
inline uint8_t slotOf(uint8_t arms, Heading entry, Heading h) {
  uint8_t slot = 0;
  for (Heading at = opposite(entry); at != h; at = static_cast<Heading>((at + 3) & 3))
    if (hasArm(arms, at)) ++slot;
  return slot;
}

}  // namespace nav

#endif
