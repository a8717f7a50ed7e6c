// Finds a robot that reads its line sensors only as often as Serial permits. At 9600 baud a byte takes 1 ms.
// A print waits until its last byte fits into Serial's buffer of 64 bytes. If a sketch prints 40 bytes in
// each control step, each step takes 40 ms, even if the sketch assumes less.
//
//   Serial.print("error "); Serial.print(error); …          // in each pass of loop(), or in each step
//
// The robot may still follow its line, since the passes of loop() are regular. However, the derivative term
// and all times that the sketch counts in passes depend on Serial. Without Serial, or on a narrower line, the
// robot drives differently.
//
// A waiting stretch is a period of at least 15 ms. In this period, the robot drives without reading a floor
// sensor, and a call of Serial waits. A finding is a sketch with at least ten waiting stretches, in sum 30 %
// of its driving time. Sketches that occasionally print much, or drive without a line, are not reported. To
// fix a finding, print fewer bytes, print less often (if (millis() - told_at > 500)), or use a faster
// Serial.begin().
#pragma once

#include <vector>

#include "sim/detect/steering_detector.h"

namespace robosim::detect {

class SlowSerial final : public SteeringDetector {
 public:
  SlowSerial(exec::Executor& executor, SnapshotRegistry& snapshots) : executor_(executor) {
    snapshots.add(state_);
  }

  void look(const Steering& now) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  void end(const Steering& now);

  struct State {
    SimTime began = 0;  ///< end of the tick in which a floor sensor was last read
    double from_m = 0.0;
    bool waits = false;              ///< a call of Serial has waited in this stretch
    SimTime driven = 0, waited = 0;  ///< total time of driving, and of waiting stretches
    int asked = 0, times = 0;
    double longest_s = 0.0, furthest_m = 0.0;
    exec::Activity first;
    SimTime first_at = 0;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
