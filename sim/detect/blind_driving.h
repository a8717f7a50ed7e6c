// Finds blind time, in which a robot drives on without reading its floor sensors and loses the line.
//
//   digitalRead(middle);  analogWrite(left, 160); …  delay(400);      // at 0.4 m/s: 160 mm without a reading
//
// Blind time has several causes: delay(), pulseIn() without a timeout, or a loop that waits. A print may also
// wait for room in Serial's buffer of 64 bytes. Blind time on a straight goes unnoticed. A finding is the
// drive from one reading of a floor sensor to the next reading, with these properties:
//
//   - the robot drove further than the distance from its axle to its sensors plus the width of the line. At
//     the end of the drive, the wheels are on floor over which no sensor was read. The robot may already have
//     passed a bend;
//   - at the first reading, a sensor was over the line. At the end of the drive, no sensor was over the line;
//   - the motor commands did not change during the drive.
//
// The last condition excludes sketches that drive blind on purpose, for example to drive round an obstacle.
// Such sketches change the motor commands between two readings.
//
// To fix a finding, compare times (millis()) instead of calling delay(). Send shorter messages or use a
// faster Serial. Give pulseIn() a timeout, and read the sensors in each loop that waits.
//
// Not detected: sketches that read their sensors and ignore the readings; blind time on straights only;
// sensors on a shift register; sensors that are read by interrupt handlers.
#pragma once

#include <vector>

#include "sim/detect/steering_detector.h"

namespace robosim::detect {

class BlindDriving final : public SteeringDetector {
 public:
  /// `lever_m` is the distance of the robot's sensors ahead of its axle; `line_m` is the width of the line.
  BlindDriving(exec::Executor& executor, SnapshotRegistry& snapshots, double lever_m, double line_m);

  void look(const Steering& now) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  /// The drive from one reading of a floor sensor to the next reading.
  struct Stretch {
    SimTime began = 0;
    double from_m = 0.0;
    bool saw_line = false;
    bool planned = false;  ///< the motor commands changed during the stretch
    double left = 0.0, right = 0.0;
    int ticks = 0;
    bool is_too_long = false;
    exec::Activity busy;  ///< the sketch's activity when the stretch became too long
  };

  struct State {
    int reads = 0;  ///< ticks with a read of a floor sensor
    Steering before;
    Stretch stretch;
    std::vector<exec::Detected> found;

    void end(const Steering& now);
    exec::Detected told(const Steering& now) const;
  };

  exec::Executor& executor_;
  const double most_m_;
  State state_;
};

}  // namespace robosim::detect
