// Constants and small functions for LineWalkerDriving.h and LineWalkerLandmarks.h.
#ifndef LINEKIT_LINE_WALKER_PARTS_H
#define LINEKIT_LINE_WALKER_PARTS_H

#include <stdint.h>

namespace line_walker {

static constexpr float kQuarter = 1.5707963f;
static constexpr float kFadeBelow = 0.15f;    // angle below which the remaining angle decays, rad
static constexpr float kFadeMm = 150;         // decay constant of the remaining angle, as a distance
static constexpr float kMostBehind = 6;       // maximum lag that the speed control corrects, mm
static constexpr float kSearch = 0.6f;        // search range on either side of a line's expected angle, rad
static constexpr float kArmNear = 0.35f;      // tolerance around a quarter turn while looking round, rad
static constexpr float kTurnedEarly = 0.05f;  // angle that the robot still turns while braking, rad
static constexpr float kCreepFrom = 3;        // distance from the end of a roll at which creeping begins, mm
static constexpr float kEndMm = 12;           // distance without a line after which the line may have ended
static constexpr float kSideMm = 150;         // search distance for a line lost to a side, mm
static constexpr float kBackUpMm = 35;
static constexpr float kNearMm = 40;  // a blocked robot backs up to a landmark within sensors_ahead + kNearMm
static constexpr float kLoopNear = 100, kLoopLeast = 500;  // tolerance and minimum length of a loop, mm
static constexpr int16_t kTurnLead = 300;  // a turn brakes if the line is this near the middle, 0.001 pitches
// An arm is present if the sensor values add up to this. A line alone gives 2100, or 2700 at 38 degrees.
static constexpr uint16_t kLineAndArm = 2700;
static constexpr uint16_t kClearMs = 500;  // time with a free bumper before the robot continues
static constexpr uint8_t kStillSteps = 4;

// Records where along the way a sensor was dark.
struct Dark {
  float from = 0, to = 0;
  bool any = false;

  void note(bool dark, float at) {
    if (!dark) return;
    if (!any) from = at;
    any = true;
    to = at;
  }
  float length() const { return to - from; }
  float middle() const { return 0.5f * (from + to); }
};

inline float magnitude(float x) { return x < 0 ? -x : x; }
inline float least(float a, float b) { return a < b ? a : b; }
inline float limited(float x, float most) { return x > most ? most : x < -most ? -most : x; }

inline int16_t dutyOf(float speed, float duty) {
  if ((speed >= 0 && duty < 0) || (speed <= 0 && duty > 0)) return 0;  // never drive in the wrong direction
  return static_cast<int16_t>(limited(duty, 255));
}

}  // namespace line_walker

#endif
