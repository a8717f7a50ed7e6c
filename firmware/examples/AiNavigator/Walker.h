// Extends LineKit's walker with this robot's LEDs, buzzer and serial messages.
#ifndef WALKER_H
#define WALKER_H

#include <LineWalker.h>

const uint8_t BUZZER_PIN = 11, JUNCTION_LED = 13, STATION_LED = A5;
const uint16_t BEEP_GOOD = 100, BEEP_BAD = 800;  // ms

inline void beep(uint16_t ms) { tone(BUZZER_PIN, ms == BEEP_GOOD ? 1760 : 440, ms); }

class Walker : public LineWalker {
 public:
  Walker(LineSensors& sensors, DriveMotors& motors, WheelEncoders& encoders, uint8_t bumper_pin)
      : LineWalker(sensors, motors, encoders, bumper_pin) {}

  void setup() {
    LineWalker::setup();
    pinMode(JUNCTION_LED, OUTPUT);
    pinMode(STATION_LED, OUTPUT);
    setOnPause(sayPause);
  }
  nav::Landmark begin() { return show(LineWalker::begin()); }
  nav::Landmark follow() {
    digitalWrite(JUNCTION_LED, LOW);
    digitalWrite(STATION_LED, LOW);
    return show(LineWalker::follow());
  }

  /// Returns whether an obstacle has blocked the way since forgetObstacle().
  bool metObstacle() const { return met_obstacle_; }
  void forgetObstacle() { met_obstacle_ = false; }

 private:
  nav::Landmark show(const nav::Landmark& met) {
    digitalWrite(JUNCTION_LED, met.kind == nav::LandmarkKind::junction ? HIGH : LOW);
    digitalWrite(STATION_LED, met.kind == nav::LandmarkKind::end ? HIGH : LOW);
    if (met.kind == nav::LandmarkKind::blocked) {
      met_obstacle_ = true;
      Serial.println(F("an obstacle: going back"));
    }
    return met;
  }
  static void sayPause(bool paused) {
    if (paused) beep(BEEP_BAD);
    Serial.println(paused ? F("collision: waiting") : F("going on"));
  }

  bool met_obstacle_ = false;
};

#endif
