// Constants and small functions of LineWalkerDriving.h and LineWalkerLandmarks.h.
#ifndef LINEKIT_LINE_WALKER_PARTS_H
#define LINEKIT_LINE_WALKER_PARTS_H

#include <stdint.h>

namespace line_walker {

static constexpr float kQuarter = 1.5707963f;
static constexpr float kFadeBelow = 0.15f;    // rad
static constexpr float kFadeMm = 150;         // time constant of fading, as a distance
static constexpr float kMostBehind = 6;       // mm that a wheel tries to catch up
static constexpr float kSearch = 0.6f;        // rad to either side of where a line should be
static constexpr float kArmNear = 0.35f;      // rad from a quarter, while looking round
static constexpr float kTurnedEarly = 0.05f;  // rad that it turns on when it brakes
static constexpr float kCreepFrom = 3;        // mm before the end of a roll
static constexpr float kEndMm = 12;           // distance without a line after which it may have ended
static constexpr float kSideMm = 150;         // so far it looks for a line lost to a side
static constexpr float kBackUpMm = 35;
static constexpr float kNearMm = 40;  // beyond sensors_ahead: turned there, it would not see the line
static constexpr float kLoopNear = 100, kLoopLeast = 500;  // mm
static constexpr int16_t kTurnLead = 300;  // 0.001 sensor distances before the middle a turn brakes
// Sum of all sensors; a line alone gives 2100, at 38 degrees 2700.
static constexpr uint16_t kLineAndArm = 2700;
static constexpr uint16_t kClearMs = 500;  // time with a free bumper before it continues
static constexpr uint8_t kStillSteps = 4;

// Where along the way a sensor was dark.
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
  if ((speed >= 0 && duty < 0) || (speed <= 0 && duty > 0)) return 0;  // never against the way it turns
  return static_cast<int16_t>(limited(duty, 255));
}

}  // namespace line_walker

#endif
